#pragma once
#include <string>

#include "lrcs/scene.h"
#include "lrcs/sweep.h"
#include "view/facet_result.h"

namespace lrcs {

// What each facet does in a row of a sweep, for files and pictures; the material is that of the side toward the
// receiver.
[[nodiscard]] FacetResult facet_result(const Target& target, const SweepRow& row, const CrossSection& section);

// "Monostatic LRCS of motor.stl".
[[nodiscard]] std::string title_of(const Scene& scene);

}  // namespace lrcs
