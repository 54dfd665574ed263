#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// The facets that a report's picture shows of a target: its own, or fewer that look like them.
// shape: triangles, part, area, value_of: one a shown facet; shown_of: one a facet of the target.
// frame: body [m]. Each facet of the target belongs to the shown facet of its part that is nearest to its middle; a
// shown facet of which no facet is part has area 0.
struct ShownTarget {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> part;
  std::vector<double> area;             // [m^2] of the target's facets that it stands for
  std::vector<std::uint32_t> value_of;  // the shown facet whose values it has: its own, or, if it stands for none,
                                        // those of the one that the target's nearest facet belongs to
  std::vector<std::uint32_t> shown_of;

  [[nodiscard]] std::size_t size() const { return triangles.size(); }
};

// At most so many shown facets, or four a part where that is more. A mesh of no more is shown as it is.
[[nodiscard]] ShownTarget shown_target(const FacetMesh& mesh, std::size_t most);

}  // namespace lrcs
