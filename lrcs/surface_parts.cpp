#include "lrcs/surface_parts.h"

#include <tbb/parallel_for.h>

#include "lrcs/convexity.h"
#include "mesh/disjoint_sets.h"

namespace lrcs {

SurfaceParts::SurfaceParts(const Occluders& occluders, const OccluderEdges& edges) : part_(occluders.size()) {
  number_parts(edges);
  list_facets();
  list_vertices(occluders);
  if (size() < 2) return;
  tbb::parallel_for(std::uint32_t{0}, size(), [&](std::uint32_t part) {
    convex_[part] = is_convex_body(occluders, edges, facets(part)) ? 1 : 0;
  });
}

SurfaceParts::SurfaceParts(const SurfaceParts& whole, const std::vector<std::uint8_t>& kept, const Occluders& occluders)
    : convex_(whole.convex_) {
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (kept[f] != 0) part_.push_back(whole.part_[f]);
  list_facets();
  list_vertices(occluders);
}

void SurfaceParts::number_parts(const OccluderEdges& edges) {
  DisjointSets sets(part_.size());
  for (std::uint32_t e = 0; e < edges.edges().size(); ++e) {
    const auto uses = edges.facets_at(e);
    for (std::size_t k = 1; k < uses.size(); ++k) sets.join(uses[0].facet, uses[k].facet);
  }
  for (std::uint32_t f = 0; f < part_.size(); ++f) {
    const std::uint32_t root = sets.root(f);
    part_[f] = root == f ? size() : part_[root];
    if (root == f) convex_.push_back(0);
  }
}

void SurfaceParts::list_facets() {
  first_facet_.assign(size() + 1, 0);
  for (const std::uint32_t part : part_) ++first_facet_[part + 1];
  for (std::uint32_t part = 0; part < size(); ++part) first_facet_[part + 1] += first_facet_[part];
  facets_.resize(part_.size());
  std::vector<std::uint32_t> next = first_facet_;
  for (std::uint32_t f = 0; f < part_.size(); ++f) facets_[next[part_[f]]++] = f;
}

void SurfaceParts::list_vertices(const Occluders& occluders) {
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> last_part(occluders.positions.size(), none);
  vertices_.reserve(last_part.size());
  for (std::uint32_t part = 0; part < size(); ++part) {
    first_vertex_.push_back(static_cast<std::uint32_t>(vertices_.size()));
    for (const std::uint32_t f : facets(part))
      for (const std::uint32_t v : occluders.facets[f]) {
        if (last_part[v] == part) continue;
        last_part[v] = part;
        vertices_.push_back(v);
      }
  }
  first_vertex_.push_back(static_cast<std::uint32_t>(vertices_.size()));
}

}  // namespace lrcs
