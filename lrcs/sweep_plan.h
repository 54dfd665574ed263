#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "lrcs/aspect.h"

namespace lrcs {

// The planes of symmetry that a sweep may use: is the target its own image where axis k is reversed?
using MirrorPlanes = std::array<bool, 3>;

// For every row the first row of the same two directions, or of two that mirror them in any of the planes; itself where
// there is none. Directions are the same where all their coordinates are equal, exactly. shape: one an aspect.
[[nodiscard]] std::vector<std::size_t> first_alike(const std::vector<Aspect>& aspects, const MirrorPlanes& planes);

// The planes that would make more rows alike, if the target is symmetric in all of them.
[[nodiscard]] MirrorPlanes planes_of_use(const std::vector<Aspect>& aspects);

}  // namespace lrcs
