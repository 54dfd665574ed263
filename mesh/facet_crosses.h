#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace lrcs {

// facet_cross() (mesh/facet_mesh.h) of many facets: the same bytes, several times sooner.
// shape: facets: N indices into positions, crosses: N. domain: as there. check: tests/mesh/facet_crosses_test.cpp.
// source: T. J. Dekker, Numer. Math. 18, 224-242, 1971: the error of a product without std::fma, which is a call where
// the machine need not have the instruction.
void facet_crosses(const std::vector<Vec3>& positions, std::span<const std::array<std::uint32_t, 3>> facets,
                   std::span<Vec3> crosses);

}  // namespace lrcs
