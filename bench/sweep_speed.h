#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace lrcs {

// A sweep of 129k facets of the bumpy sphere with 1 and with 2 threads, in turns. value: what to print.
[[nodiscard]] std::string thread_scaling(std::size_t directions, int runs);

// Facets times directions that a monostatic sweep of a convex target gets through in a second, one thread, five
// parameters, beside what one pass over the facets' normals and areas (32 bytes a facet) would allow at the measured
// copy bandwidth. Building the target is not counted. value: what to print.
[[nodiscard]] std::string convex_sweep_speed(std::uint32_t subdivisions, std::size_t directions, int runs);

}  // namespace lrcs
