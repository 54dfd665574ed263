#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// Changes to a mesh's facets that keep all lists with an entry a facet in step. Normals and areas are left as they are:
// measure_facets() must follow.

// Drops the facets of which `drop` is true, asked in order, and says how many they were. The others keep their order.
std::size_t drop_facets(FacetMesh& mesh, const std::function<bool(std::size_t)>& drop);

// Adds a facet that has the part, material, source facet and all else that the file says of facet `like`.
// domain: `like` is flat.
void add_facet_like(FacetMesh& mesh, std::size_t like, const std::array<std::uint32_t, 3>& corners);

// Reverses the winding of some facets.
void turn_over(FacetMesh& mesh, const std::vector<std::uint32_t>& facets);

// The facets of every part, ascending. shape: one list a name of mesh.part.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> facets_of_parts(const FacetMesh& mesh);

}  // namespace lrcs
