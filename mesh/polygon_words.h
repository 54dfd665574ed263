#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// A word for each polygon of a file, "" until it is set: what a FacetProperty holds of facets.
class PolygonWords {
 public:
  // Of a polygon by its number in the file, from 0.
  void set(std::size_t polygon, std::string_view word);

  // Of the facets that the polygons were cut into. law: words of no facet leave no trace.
  [[nodiscard]] FacetNames of_facets(const FacetMesh& mesh) const;

 private:
  std::vector<std::uint32_t> of_;  // index into words_, one a polygon
  std::vector<std::string> words_{""};
  std::unordered_map<std::string, std::uint32_t> known_{{"", 0}};
};

}  // namespace lrcs
