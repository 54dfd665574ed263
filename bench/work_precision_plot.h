#pragma once
#include <filesystem>
#include <vector>

#include "bench/summary.h"

namespace lrcs {

// Writes a PNG, 1600 x 1200 pixels: relative error of sigma (Wu) against time, both logarithmic, one curve a family of
// methods. The exact method has no error to draw: it is the line of its time, and what lies right of it is slower.
// domain: one target; the exact method and at least one other, of error above zero.
void draw_work_precision(const std::filesystem::path& png, const std::vector<Summary>& of_target,
                         std::size_t directions);

}  // namespace lrcs
