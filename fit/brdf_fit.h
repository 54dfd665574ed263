#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "fit/fit_options.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

struct FittedParameter {
  std::string name, meaning;
  double value = 0.0;
  double standard_error = 0.0;  // [unit of the parameter]; infinite where the data do not tell
  double half_width_95 = 0.0;   // of the interval that holds the truth with a chance of 95 % [same]
  bool determined = false;
  std::string why_not;  // in words, where it is not
};

// A model fitted to a measurement.
struct BrdfFit {
  std::string form;
  Material material;  // with the measurement's wavelength; azimuth_of_specular 180
  std::vector<FittedParameter> parameters;
  Eigen::MatrixXd correlation;  // [1] of the parameters' errors
  double e_percent = 0.0;       // the norm E [%]
  double rms_logarithm = 0.0;   // root mean square of ln(model/measured) where both are > 0 [1]
  // Bayes' information criterion: n ln(mean square) + parameters ln n; at least rounding_of_squares
  double criterion = 0.0;
  std::size_t samples = 0;  // of weight above 0
  int evaluations = 0;
  std::uint64_t seed = 0;
  bool converged = false;
  std::string status;                 // in words
  std::vector<std::string> warnings;  // a sentence each: of the data, and where the material would mislead
};

// value: E = 100 Sum w (f cos_r - f0 cos_r)^2 / Sum w (f0 cos_r)^2 [%], f0 measured, w the samples' weights.
[[nodiscard]] double norm_e(const Brdf& brdf, const std::vector<BrdfSample>& samples);

// The form's parameters for which the residuals of `options.residual` are least, anywhere in their ranges.
// laws: the same bytes for the same seed on any thread count. A nine-parameter fit is at least as good as a
//   five-parameter one of the same data. A sample of weight 0 changes nothing.
// error: InputError that names the measurement: fewer samples than parameters, no f_r above 0, or a value of 0 under
//   logarithmic residuals.
// check: tests/fit/brdf_fit_test.cpp: truth without noise; tests/fit/search_test.cpp: no descent of 100 from anywhere
// is
//   better.
// source: docs/fitting.md.
[[nodiscard]] BrdfFit fit_brdf(const BrdfMeasurement& measurement, std::string_view form,
                               const FitOptions& options = {});

}  // namespace lrcs
