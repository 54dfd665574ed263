#include "lrcs/surface.h"

#include "lrcs/solids.h"

namespace lrcs {
namespace {

std::vector<std::uint8_t> kept_of(const std::vector<std::uint8_t>& values, const std::vector<std::uint8_t>& kept) {
  std::vector<std::uint8_t> left;
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (kept[k] != 0) left.push_back(values[k]);
  return left;
}

}  // namespace

Surface::Surface(const FacetMesh& mesh)
    : occluders(mesh),
      tree(occluders),
      edges(occluders),
      contacts(occluders, tree, edges),
      of_solid(solid_facets(occluders, tree, edges, contacts)),
      parts(occluders, edges),
      hull(occluders, edges, contacts, of_solid, parts) {
  list_positions();
}

Surface::Surface(const Surface& whole, const std::vector<std::uint8_t>& kept)
    : occluders(whole.occluders, kept),
      tree(occluders),
      edges(occluders),
      contacts(occluders, tree, edges),
      of_solid(kept_of(whole.of_solid, kept)),
      parts(whole.parts, kept, occluders),
      hull(whole.hull, kept) {
  list_positions();
}

void Surface::list_positions() {
  for (auto* list : {&x, &y, &z}) list->reserve(occluders.positions.size());
  for (const Vec3& p : occluders.positions) {
    x.push_back(p.x() - occluders.centre.x());
    y.push_back(p.y() - occluders.centre.y());
    z.push_back(p.z() - occluders.centre.z());
  }
}

}  // namespace lrcs
