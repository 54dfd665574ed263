#pragma once
#include <string>
#include <vector>

#include "fit/brdf_fit.h"

namespace lrcs {

// A fit for people to read: E, parameters with standard errors, what the data do not determine, strong correlations.
[[nodiscard]] std::string fit_text(const BrdfFit& fit);

// Several models fitted to the same data, one a line, the least criterion first.
[[nodiscard]] std::string comparison_text(const std::vector<BrdfFit>& fits);

// keys: model, e_percent, rms_logarithm, criterion, parameters: {name: {value, standard_error, interval_95, determined,
// reason}}, correlation (rows in the order of the parameters), samples, evaluations, seed, converged, status, warnings,
// notes, wavelength_m, azimuth_of_specular, data, version. Numbers that are not finite are null.
[[nodiscard]] std::string fit_json(const BrdfFit& fit, const BrdfMeasurement& measurement);

}  // namespace lrcs
