#include "mesh/mesh_builder.h"

#include <cassert>
#include <limits>
#include <utility>

#include "base/input_error.h"
#include "mesh/polygon_cut.h"

namespace lrcs {

void MeshBuilder::Names::begin(std::string_view new_name) {
  if (new_name == name) return;
  name = new_name;
  index = -1;
}

std::uint32_t MeshBuilder::Names::use(std::vector<std::string>& names) {
  if (index < 0) {
    const auto [entry, is_new] = known.try_emplace(name, static_cast<std::uint32_t>(names.size()));
    if (is_new) names.push_back(name);
    index = entry->second;
  }
  return static_cast<std::uint32_t>(index);
}

void MeshBuilder::reserve(std::size_t vertices, std::size_t facets) {
  mesh_.positions.reserve(mesh_.positions.size() + vertices);
  mesh_.facets.reserve(mesh_.size() + facets);
  for (auto* list : {&mesh_.part.of, &mesh_.file_material.of, &mesh_.colour.of, &mesh_.layer.of, &mesh_.source_facet})
    list->reserve(mesh_.size() + facets);
}

std::uint32_t MeshBuilder::add_position(const Vec3& position) {
  const std::size_t index = mesh_.positions.size();
  if (index >= std::numeric_limits<std::uint32_t>::max())
    throw InputError("more than 4294967294 vertices, expected fewer");
  mesh_.positions.push_back(position);
  return static_cast<std::uint32_t>(index);
}

void MeshBuilder::add_polygon(std::span<const std::uint32_t> corners) {
  assert(corners.size() >= 3);
  cut_.clear();
  cut_polygon(mesh_.positions, corners, cut_);
  add_facets(cut_);
}

void MeshBuilder::add_facets(std::span<const std::array<std::uint32_t, 3>> facets) {
  mesh_.facets.insert(mesh_.facets.end(), facets.begin(), facets.end());
  mesh_.part.of.resize(mesh_.size(), part_.use(mesh_.part.names));
  mesh_.file_material.of.resize(mesh_.size(), material_.use(mesh_.file_material.names));
  mesh_.colour.of.resize(mesh_.size(), colour_.use(mesh_.colour.names));
  mesh_.layer.of.resize(mesh_.size(), layer_.use(mesh_.layer.names));
  mesh_.source_facet.resize(mesh_.size(), polygons_++);
}

FacetMesh MeshBuilder::finish() {
  for (FacetNames* told : {&mesh_.colour, &mesh_.layer})
    if (told->names == std::vector<std::string>{""}) *told = {};
  measure_facets(mesh_);
  return std::exchange(mesh_, FacetMesh());
}

}  // namespace lrcs
