#include "lrcs/surface.h"

#include <algorithm>
#include <numeric>

#include "lrcs/facet_frame.h"

namespace lrcs {
namespace {

// Connected pieces of a surface: across edges of two facets.
class Pieces {
 public:
  explicit Pieces(std::size_t facets) : parent_(facets), broken_(facets, 0) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t root(std::uint32_t facet) {
    while (parent_[facet] != facet) facet = parent_[facet] = parent_[parent_[facet]];
    return facet;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  // Once all are joined: this facet's piece is no solid.
  void mark(std::uint32_t facet) { broken_[root(facet)] = 1; }
  [[nodiscard]] bool is_marked(std::uint32_t facet) { return broken_[root(facet)] != 0; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> broken_;
};

bool is_ordinary(std::span<const FacetAtEdge> facets) {
  return facets.size() == 2 && facets[0].rising != facets[1].rising;
}

void mark_contacts_with_itself(const Occluders& occluders, const OccluderEdges& edges, const Contacts& contacts,
                               Pieces& pieces) {
  for (std::uint32_t f = 0; f < occluders.size(); ++f) {
    if (!contacts.any(f)) continue;
    const auto of = contacts.of(f);
    const auto meets = [&](std::uint32_t other) {
      if (pieces.root(other) == pieces.root(f)) pieces.mark(f);
    };
    for (const auto& passage : of.passages) meets(passage.facet);
    for (const auto& lying : of.edges)
      for (const FacetAtEdge& use : edges.facets_at(lying.edge)) meets(use.facet);
    if (of.covered) pieces.mark(f);
  }
}

// Marks the pieces whose six-fold volume is not certainly positive.
void mark_empty(const Occluders& occluders, Pieces& pieces) {
  std::vector<double> volume(occluders.size(), 0.0), size(occluders.size(), 0.0);
  for (std::uint32_t f = 0; f < occluders.size(); ++f) {
    const std::uint32_t root = pieces.root(f);
    const Vec3& origin = occluders.positions[occluders.facets[root][0]];
    const Vec3 terms = occluders.cross[f].cwiseProduct(occluders.positions[occluders.facets[f][0]] - origin);
    volume[root] += terms.sum();
    size[root] += terms.lpNorm<1>();
  }
  // Each term is right to a few roundings; a sum of n adds n more.
  const double rounding = 8.0 * unit_roundoff * static_cast<double>(occluders.size() + 8);
  for (std::uint32_t f = 0; f < occluders.size(); ++f)
    if (pieces.root(f) == f && volume[f] <= rounding * size[f]) pieces.mark(f);
}

}  // namespace

std::vector<std::uint8_t> solid_facets(const Occluders& occluders, const OccluderEdges& edges,
                                       const Contacts& contacts) {
  Pieces pieces(occluders.size());
  const auto count = static_cast<std::uint32_t>(edges.edges().size());
  for (std::uint32_t e = 0; e < count; ++e)
    if (const auto facets = edges.facets_at(e); is_ordinary(facets)) pieces.join(facets[0].facet, facets[1].facet);
  for (std::uint32_t e = 0; e < count; ++e)
    if (const auto facets = edges.facets_at(e); !is_ordinary(facets))
      for (const FacetAtEdge& use : facets) pieces.mark(use.facet);
  mark_contacts_with_itself(occluders, edges, contacts, pieces);
  mark_empty(occluders, pieces);
  std::vector<std::uint8_t> solid(occluders.size());
  for (std::uint32_t f = 0; f < occluders.size(); ++f) solid[f] = pieces.is_marked(f) ? 0 : 1;
  return solid;
}

Surface::Surface(const FacetMesh& mesh)
    : occluders(mesh),
      tree(occluders),
      edges(occluders),
      contacts(occluders, tree, edges),
      of_solid(solid_facets(occluders, edges, contacts)) {
  for (const Vec3& p : occluders.positions) {
    x.push_back(p.x() - occluders.centre.x());
    y.push_back(p.y() - occluders.centre.y());
    z.push_back(p.z() - occluders.centre.z());
  }
}

}  // namespace lrcs
