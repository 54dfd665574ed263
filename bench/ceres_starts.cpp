#include "bench/ceres_starts.h"

#include <ceres/ceres.h>

#include "fit/ceres_residuals.h"
#include "fit/uniform.h"

namespace lrcs {
namespace {

ceres::Solver::Options to_the_end() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 500;
  options.function_tolerance = 1e-15;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  return options;
}

ceres::Solver::Options briefly() {
  ceres::Solver::Options options = to_the_end();
  const ceres::Solver::Options usual;
  options.max_num_iterations = 100;
  options.function_tolerance = usual.function_tolerance;
  options.gradient_tolerance = usual.gradient_tolerance;
  options.parameter_tolerance = usual.parameter_tolerance;
  return options;
}

class Descents {
 public:
  explicit Descents(const FitTask& task) : task_(task), random_(task.data.seed) {}

  FitEnd run(int starts) {
    for (int k = 0; k < starts; ++k) {
      std::vector<double> place(task_.box.dimensions());
      for (double& x : place) x = random_.next();
      descend_from(task_.box.values_at_place(place), briefly());
    }
    descend_from(best_, to_the_end());
    return {best_, evaluations_};
  }

 private:
  void descend_from(const std::vector<double>& start, const ceres::Solver::Options& options) {
    const auto parameters = task_.box.problem().parameters();
    std::vector<double> place(start.size());
    for (std::size_t k = 0; k < place.size(); ++k) place[k] = coordinate_of(parameters[k], start[k]);
    ceres::Problem problem;
    problem.AddResidualBlock(new CeresResiduals(task_.box.problem()), nullptr, place.data());  // NOLINT: Ceres owns it
    for (std::size_t k = 0; k < place.size(); ++k) {
      const auto& p = parameters[k];
      problem.SetParameterLowerBound(place.data(), static_cast<int>(k), coordinate_of(p, p.least));
      problem.SetParameterUpperBound(place.data(), static_cast<int>(k), coordinate_of(p, p.most));
    }
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    evaluations_ += summary.num_residual_evaluations + summary.num_jacobian_evaluations;
    for (std::size_t k = 0; k < place.size(); ++k) place[k] = value_at(parameters[k], place[k]);
    const double squares = task_.box.squares(place);
    if (!best_.empty() && squares >= least_) return;
    least_ = squares;
    best_ = place;
  }

  const FitTask& task_;
  Uniform random_;
  std::vector<double> best_;
  double least_ = 0.0;
  long evaluations_ = 0;
};

}  // namespace

FitEnd ceres_starts(const FitTask& task, int starts) {
  return Descents(task).run(starts);
}

}  // namespace lrcs
