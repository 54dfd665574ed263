#include "mesh/facet_lists.h"

#include <utility>

#include "base/large_pages.h"

namespace lrcs {
namespace {

// Those that are not empty.
std::vector<std::vector<std::uint32_t>*> lists_of(FacetMesh& mesh) {
  std::vector lists{&mesh.part.of,  &mesh.file_material.of, &mesh.colour.of,
                    &mesh.layer.of, &mesh.source_facet,     &mesh.curved.of};
  for (FacetProperty& property : mesh.properties) lists.push_back(&property.values.of);
  std::erase_if(lists, [](const auto* list) { return list->empty(); });
  return lists;
}

}  // namespace

std::size_t drop_facets(FacetMesh& mesh, const std::function<bool(std::size_t)>& drop) {
  std::size_t kept = 0;
  while (kept < mesh.size() && !drop(kept)) ++kept;
  if (kept == mesh.size()) return 0;
  const auto lists = lists_of(mesh);
  for (std::size_t k = kept + 1; k < mesh.size(); ++k) {
    if (drop(k)) continue;
    mesh.facets[kept] = mesh.facets[k];
    for (auto* list : lists) (*list)[kept] = (*list)[k];
    ++kept;
  }
  const std::size_t dropped = mesh.size() - kept;
  mesh.facets.resize(kept);
  for (auto* list : lists) list->resize(kept);
  return dropped;
}

void add_facet_like(FacetMesh& mesh, std::size_t like, const std::array<std::uint32_t, 3>& corners) {
  for (auto* list : lists_of(mesh)) list->push_back((*list)[like]);
  mesh.facets.push_back(corners);
}

void turn_over(FacetMesh& mesh, const std::vector<std::uint32_t>& facets) {
  for (const std::uint32_t facet : facets) {
    std::swap(mesh.facets[facet][1], mesh.facets[facet][2]);
    if (!mesh.curved.of.empty() && mesh.curved.of[facet] != CurvedFacets::flat)
      turn_over(mesh.curved.patches[mesh.curved.of[facet]]);
  }
}

std::vector<std::vector<std::uint32_t>> facets_of_parts(const FacetMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> parts(mesh.part.names.size());
  std::vector<std::size_t> sizes(parts.size(), 0);
  for (const std::uint32_t part : mesh.part.of) ++sizes[part];
  for (std::size_t p = 0; p < parts.size(); ++p) reserve_large(parts[p], sizes[p]);
  for (std::uint32_t k = 0; k < mesh.size(); ++k) parts[mesh.part.of[k]].push_back(k);
  return parts;
}

}  // namespace lrcs
