#pragma once
#include <cstdint>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// What each part returns in one direction.
// value: the sum of its facets' shares [m^2], compensated. shape: one a part. law: the parts' sums add up to that of
// all facets within 1e-15 of it.
[[nodiscard]] std::vector<double> part_returns(const FacetMesh& mesh, const std::vector<double>& facet_sigma);

// Numbers of the parts that return most, the strongest first; equal ones in their order; those that return nothing are
// left out. At most so many.
[[nodiscard]] std::vector<std::uint32_t> strongest_parts(const std::vector<double>& part_sigma, std::size_t most);

}  // namespace lrcs
