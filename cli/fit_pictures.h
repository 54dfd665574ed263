#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fit/brdf_fit.h"

namespace lrcs {

// Draws, beside a material's file M.yaml, what was measured in the plane of incidence with the fit and its residuals
// into M.png, and the shadowing function of a model that has one into M-shadowing.png. Samples off the plane are not
// drawn, which the picture says. Returns the files drawn: none where nothing was measured in the plane.
std::vector<std::filesystem::path> draw_fit_pictures(const std::filesystem::path& material, const BrdfFit& fit,
                                                     const BrdfMeasurement& measurement);

}  // namespace lrcs
