#include "lrcs/surface.h"

#include "lrcs/solids.h"

namespace lrcs {

Surface::Surface(const FacetMesh& mesh)
    : occluders(mesh),
      tree(occluders),
      edges(occluders),
      contacts(occluders, tree, edges),
      of_solid(solid_facets(occluders, tree, edges, contacts)) {
  for (const Vec3& p : occluders.positions) {
    x.push_back(p.x() - occluders.centre.x());
    y.push_back(p.y() - occluders.centre.y());
    z.push_back(p.z() - occluders.centre.z());
  }
}

}  // namespace lrcs
