#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mesh/coordinate.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// Puts a FacetMesh together from the vertices and polygons of a file, in file order.
// laws: equal part names are one part, equal material names one material; a name without polygons leaves no trace.
class MeshBuilder {
 public:
  // Makes room for so many more vertices and facets, if it is known how many come.
  void reserve(std::size_t vertices, std::size_t facets);

  // Adds a vertex and gives its index. domain: coordinates for which is_coordinate() holds.
  std::uint32_t add_position(const Vec3& position);
  // The same of many vertices.
  void add_positions(std::vector<Vec3> positions);
  [[nodiscard]] std::size_t position_count() const { return mesh_.positions.size(); }
  [[nodiscard]] const Vec3& position(std::uint32_t k) const { return mesh_.positions[k]; }

  // The part, the material, the colour and the layer of the polygons that follow; "" before the first call.
  void begin_part(std::string_view name) { part_.begin(name); }
  void begin_material(std::string_view name) { material_.begin(name); }
  void begin_colour(std::string_view name) { colour_.begin(name); }
  void begin_layer(std::string_view name) { layer_.begin(name); }

  // Adds a polygon, cut into facets (mesh/polygon_cut.h).
  // domain: at least 3 corners, indices of vertices already added.
  void add_polygon(std::span<const std::uint32_t> corners);
  // What the last one was cut into.
  [[nodiscard]] std::span<const std::array<std::uint32_t, 3>> last_polygon() const { return cut_; }

  // Adds facets of one polygon of the file, cut already. domain: indices of vertices already added.
  void add_facets(std::span<const std::array<std::uint32_t, 3>> facets);

  // Adds facets, each a polygon of its own. domain: as above.
  void add_triangles(std::vector<std::array<std::uint32_t, 3>> facets);

  // The mesh, measured; without colours or layers where none has a name. The builder is empty after that.
  [[nodiscard]] FacetMesh finish();

 private:
  // Names numbered in the order of their first use.
  struct Names {
    std::string name;
    std::int64_t index = -1;  // of name; -1: not used yet
    std::unordered_map<std::string, std::uint32_t> known;

    void begin(std::string_view new_name);
    std::uint32_t use(std::vector<std::string>& names);
    std::uint32_t use_nameless(std::vector<std::string>& names);  // of ""
  };

  void reserve_names(std::size_t facets);
  void require_room(std::size_t more) const;
  void name_facets(std::size_t before);

  FacetMesh mesh_;
  Names part_, material_, colour_, layer_;
  std::uint32_t polygons_ = 0;
  std::vector<std::array<std::uint32_t, 3>> cut_;
};

}  // namespace lrcs
