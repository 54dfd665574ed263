#pragma once
#include <Eigen/Core>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "brdf/brdf_form.h"
#include "fit/fit_options.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

// One sample as the fit sees it.
struct FitRow {
  Vec3 wi, wr;          // the normal is z
  double cos_i, cos_r;  // of the sample's angles
  double f_r;           // [1/sr]
  double root_weight;   // [1]
};

// Sum of the squares of linear residuals, which is 1 where the model is 0: up to here the models' own error, 1e-12.
inline constexpr double rounding_of_squares = 1e-24;

// The differences between a form of a model and samples, as functions of the form's parameters.
// value: residual [1], scaled so that their squares add up to E/100 (linear residuals), or to the weighted mean square
//   of ln(f_r/measured) (logarithmic ones).
class FitProblem {
 public:
  virtual ~FitProblem() = default;
  FitProblem() = default;
  FitProblem(const FitProblem&) = delete;
  FitProblem& operator=(const FitProblem&) = delete;

  [[nodiscard]] virtual std::span<const FormParameter> parameters() const = 0;
  [[nodiscard]] virtual std::size_t rows() const = 0;

  // Of a vector of all parameters. shape: one residual a row; jacobian (rows x parameters) unless null.
  virtual void residuals(std::span<const double> parameters, Eigen::VectorXd& residual,
                         Eigen::MatrixXd* jacobian) const = 0;

  // The variance of a residual by each kind of noise there may be in f_r cos_r: of the same variance everywhere (a
  // detector's), of one that is as the value (counted photons), as its square (a source's), and as the inverse of the
  // weight, which is what weights usually are. Values are the model's. shape: a row a residual, a column a kind.
  [[nodiscard]] virtual Eigen::MatrixXd variance_basis(std::span<const double> parameters) const = 0;

  // The linear parameters that fit best where the others are as given: set in `parameters`.
  // value: the sum of squared residuals there. Non-negative least squares; logarithmic residuals are taken to first
  // order.
  [[nodiscard]] virtual double solve_linear(std::span<double> parameters) const = 0;
};

// domain: samples not empty, some f_r cos(theta_r) > 0; every f_r > 0 for logarithmic residuals.
[[nodiscard]] std::unique_ptr<FitProblem> fit_problem(std::string_view form, int azimuth_of_specular,
                                                      const std::vector<BrdfSample>& samples, Residual residual);

}  // namespace lrcs
