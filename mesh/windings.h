#pragma once
#include <cstdint>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// The facets that are wound against most of the facets they are connected with: turned over, their piece of the surface
// faces one way. Facets are connected across edges that two facets of one part use. Where as many face either way,
// those that face as the piece's first facet are kept. value: facets, ascending; none of a piece that has no two sides
// (a Moebius band). domain: a welded mesh, facets of three different vertices. cost: O(N log N).
[[nodiscard]] std::vector<std::uint32_t> facets_against_most(const FacetMesh& welded);

}  // namespace lrcs
