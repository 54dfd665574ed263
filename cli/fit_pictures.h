#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fit/brdf_fit.h"

namespace lrcs {

// Some sample lies in the plane of incidence: only these are drawn.
[[nodiscard]] bool is_measured_in_plane(const BrdfMeasurement& measurement);

// Beside a material's file M.yaml: M.png and M-shadowing.png, or .svg.
struct FitPictureFiles {
  std::filesystem::path fit, shadowing;
};
[[nodiscard]] FitPictureFiles picture_files(const std::filesystem::path& material, const std::string& ending);

// Draws what was measured in the plane of incidence with the fit and its residuals, of the kind that was minimised, and
// the shadowing function of a model that has one.
// Samples off the plane are not drawn, and of many incidence angles a few spread ones, which the pictures say. Returns
// the files drawn: none where nothing was measured in the plane.
// time: grows with the samples by what it takes to look at each once.
std::vector<std::filesystem::path> draw_fit_pictures(const FitPictureFiles& files, const BrdfFit& fit,
                                                     const BrdfMeasurement& measurement, Residual residual);

}  // namespace lrcs
