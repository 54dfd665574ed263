#pragma once
#include <string_view>
#include <utility>
#include <vector>

#include "fit/fit_problem.h"

namespace lrcs {

// Residual A x - t: everything about it is known in closed form. x[k] within [least, most] of its parameter; noise has
// one variance.
class LinearProblem final : public FitProblem {
 public:
  LinearProblem(Eigen::MatrixXd a, Eigen::VectorXd t, std::vector<std::pair<double, double>> ranges)
      : a_(std::move(a)), t_(std::move(t)) {
    for (const auto& [least, most] : ranges) parameters_.push_back({"x", "[1]", least, most, 0.0, 1.0});
  }

  [[nodiscard]] std::span<const FormParameter> parameters() const override { return parameters_; }
  [[nodiscard]] std::size_t rows() const override { return static_cast<std::size_t>(t_.size()); }
  void residuals(std::span<const double> x, Eigen::VectorXd& residual, Eigen::MatrixXd* jacobian) const override {
    residual = a_ * Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())) - t_;
    if (jacobian != nullptr) *jacobian = a_;
  }
  [[nodiscard]] Eigen::MatrixXd variance_basis(std::span<const double> /*parameters*/) const override {
    return Eigen::MatrixXd::Ones(t_.size(), 1);
  }
  [[nodiscard]] double solve_linear(std::span<double> /*parameters*/) const override { return 0.0; }

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd t_;
  std::vector<FormParameter> parameters_;
};

}  // namespace lrcs
