#include "fit/polish.h"

#include <ceres/ceres.h>

#include <Eigen/QR>

#include "fit/ceres_residuals.h"
#include "fit/linearised.h"

namespace lrcs {
namespace {

std::vector<double> values_at(const FitProblem& problem, const double* coordinates) {
  std::vector<double> values(problem.parameters().size());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = value_at(problem.parameters()[k], coordinates[k]);
  return values;
}

ceres::Solver::Options solver_options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-15;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  return options;
}

std::vector<int> at_an_end(const FitProblem& problem, const std::vector<double>& values) {
  std::vector<int> held;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (is_at_end(problem.parameters()[k], values[k])) held.push_back(static_cast<int>(k));
  return held;
}

}  // namespace

Polished polish(const FitProblem& problem, const std::vector<double>& start) {
  const auto size = static_cast<int>(start.size());
  const std::vector<int> held = at_an_end(problem, start);
  std::vector<double> coordinates(start.size());
  for (std::size_t k = 0; k < start.size(); ++k) coordinates[k] = coordinate_of(problem.parameters()[k], start[k]);
  ceres::Problem ceres_problem;
  ceres_problem.AddResidualBlock(new CeresResiduals(problem), nullptr, coordinates.data());  // NOLINT: Ceres owns it
  if (!held.empty())
    ceres_problem.SetManifold(coordinates.data(), new ceres::SubsetManifold(size, held));  // NOLINT: Ceres owns it
  for (int k = 0; k < size; ++k) {
    const FormParameter& p = problem.parameters()[static_cast<std::size_t>(k)];
    ceres_problem.SetParameterLowerBound(coordinates.data(), k, coordinate_of(p, p.least));
    ceres_problem.SetParameterUpperBound(coordinates.data(), k, coordinate_of(p, p.most));
  }
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(), &ceres_problem, &summary);
  std::vector<double> values = values_at(problem, coordinates.data());
  for (const int k : held) values[static_cast<std::size_t>(k)] = start[static_cast<std::size_t>(k)];
  return {values, 2.0 * summary.final_cost, summary.num_residual_evaluations,
          summary.termination_type == ceres::CONVERGENCE};
}

bool is_least(const FitProblem& problem, const std::vector<double>& parameters) {
  constexpr double worth_while = 1e-6;  // relative fall of the squares
  const Linearised l(problem, parameters);
  const double squares = l.residual.squaredNorm();
  if (squares <= rounding_of_squares || l.free.empty()) return true;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(l.jacobian);
  const Eigen::VectorXd along = (qr.householderQ().adjoint() * l.residual).head(qr.rank());
  return along.squaredNorm() <= worth_while * squares;
}

}  // namespace lrcs
