#include "mesh/mesh_builder.h"

#include <cassert>
#include <limits>
#include <utility>

#include "base/input_error.h"
#include "base/large_pages.h"
#include "mesh/polygon_cut.h"

namespace lrcs {
namespace {

template <class T>
void append(std::vector<T>& list, std::vector<T> more) {
  if (list.empty())
    list = std::move(more);
  else
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

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

std::uint32_t MeshBuilder::Names::use_nameless(std::vector<std::string>& names) {
  const auto [entry, is_new] = known.try_emplace("", static_cast<std::uint32_t>(names.size()));
  if (is_new) names.emplace_back();
  return entry->second;
}

void MeshBuilder::reserve(std::size_t vertices, std::size_t facets) {
  reserve_large(mesh_.positions, mesh_.positions.size() + vertices);
  reserve_large(mesh_.facets, mesh_.size() + facets);
  reserve_names(mesh_.size() + facets);
}

void MeshBuilder::reserve_names(std::size_t facets) {
  for (auto* list : {&mesh_.part.of, &mesh_.file_material.of, &mesh_.source_facet}) reserve_large(*list, facets);
}

void MeshBuilder::require_room(std::size_t more) const {
  if (more > std::numeric_limits<std::uint32_t>::max() - mesh_.positions.size())
    throw InputError("more than 4294967295 vertices, expected fewer");
}

std::uint32_t MeshBuilder::add_position(const Vec3& position) {
  require_room(1);
  mesh_.positions.push_back(position);
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void MeshBuilder::add_positions(std::vector<Vec3> positions) {
  require_room(positions.size());
  append(mesh_.positions, std::move(positions));
}

void MeshBuilder::add_polygon(std::span<const std::uint32_t> corners) {
  assert(corners.size() >= 3);
  cut_.clear();
  cut_polygon(mesh_.positions, corners, cut_);
  add_facets(cut_);
}

void MeshBuilder::add_facets(std::span<const std::array<std::uint32_t, 3>> facets) {
  const std::size_t before = mesh_.size();
  mesh_.facets.insert(mesh_.facets.end(), facets.begin(), facets.end());
  name_facets(before);
  mesh_.source_facet.resize(mesh_.size(), polygons_++);
}

void MeshBuilder::add_triangles(std::vector<std::array<std::uint32_t, 3>> facets) {
  const std::size_t before = mesh_.size();
  append(mesh_.facets, std::move(facets));
  reserve_names(mesh_.size());
  name_facets(before);
  while (mesh_.source_facet.size() < mesh_.size()) mesh_.source_facet.push_back(polygons_++);
}

// Gives the facets that were added last their part, material, colour and layer.
void MeshBuilder::name_facets(std::size_t before) {
  if (mesh_.size() == before) return;
  mesh_.part.of.resize(mesh_.size(), part_.use(mesh_.part.names));
  mesh_.file_material.of.resize(mesh_.size(), material_.use(mesh_.file_material.names));
  for (auto [told, names] : {std::pair(&mesh_.colour, &colour_), std::pair(&mesh_.layer, &layer_)}) {
    if (told->of.empty() && names->name.empty()) continue;  // there may be none
    if (told->of.size() < before) told->of.resize(before, names->use_nameless(told->names));
    told->of.resize(mesh_.size(), names->use(told->names));
  }
}

FacetMesh MeshBuilder::finish() {
  measure_facets(mesh_);
  return std::exchange(mesh_, FacetMesh());
}

}  // namespace lrcs
