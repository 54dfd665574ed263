#pragma once
#include <span>
#include <vector>

#include "fit/fit_problem.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

// The search range of all of a form's parameters as a unit cube, for methods that take the linear ones as any other:
// the coordinates of fit/coordinate.h; linear parameters 0 to twice the largest measured f_r cos(theta_r).
class FitBox {
 public:
  // Keeps a reference to the problem.
  FitBox(const FitProblem& problem, const std::vector<BrdfSample>& samples);

  [[nodiscard]] const FitProblem& problem() const { return problem_; }
  [[nodiscard]] std::size_t dimensions() const { return problem_.parameters().size(); }

  // The parameters at a place; beyond the cube too, as far as [least, most] goes.
  [[nodiscard]] std::vector<double> values_at_place(std::span<const double> place) const;
  // Whether a place in the cube has these parameters.
  [[nodiscard]] bool holds(const std::vector<double>& values) const;

  // Sum of squared residuals; huge where it is not a number.
  [[nodiscard]] double squares(const std::vector<double>& values) const;
  [[nodiscard]] double squares_at(std::span<const double> place) const { return squares(values_at_place(place)); }

 private:
  const FitProblem& problem_;
  double most_linear_ = 0.0;  // [1/sr]
};

}  // namespace lrcs
