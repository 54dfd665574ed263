#include "bench/fit_comparison.h"

#include <algorithm>

#include "bench/fit_methods.h"
#include "bench/processor_time.h"
#include "fit/descent.h"

namespace lrcs {
namespace {

class Contest {
 public:
  Contest(std::string form, const FitData& data)
      : form_(std::move(form)),
        data_(data),
        problem_(fit_problem(form_, 180, data.measurement.samples, Residual::linear)),
        box_(*problem_, data.measurement.samples) {}

  FitComparison run(const std::vector<FitMethod>& methods, int reference) {
    for (const FitMethod& method : methods) measure(method.name, [&] { return method.run({form_, data_, box_}); });
    Uniform random(data_.seed ^ 0x4efU);
    for (int k = 0; k < reference; ++k)
      measure(std::string(one_descent_name), [&] { return one_descent(box_, random); });
    const double from_truth = polished(true_parameters(*data_.material, form_));
    for (FitRun& r : runs_) r.best = best_squares_;
    return {runs_, box_.holds(best_), is_success(from_truth, best_squares_)};
  }

 private:
  template <class Call>
  void measure(const std::string& name, const Call& call) {
    FitRun run{.method = name, .noise = data_.noise};
    const ProcessorTime time;
    const FitEnd end = call();
    run.seconds = time.seconds();
    run.evaluations = end.evaluations;
    run.squares = noted(end.parameters);
    run.polished = std::min(run.squares, polished(end.parameters));
    runs_.push_back(run);
  }

  double polished(const std::vector<double>& start) { return noted(descend(*problem_, start, {}).parameters); }

  double noted(const std::vector<double>& parameters) {
    const double squares = box_.squares(parameters);
    if (best_.empty() || squares < best_squares_) {
      best_ = parameters;
      best_squares_ = squares;
    }
    return squares;
  }

  std::string form_;
  const FitData& data_;
  std::unique_ptr<FitProblem> problem_;
  FitBox box_;
  std::vector<FitRun> runs_;
  std::vector<double> best_;
  double best_squares_ = 0.0;
};

}  // namespace

FitComparison compare_fits(const std::vector<FitMethod>& methods, const std::string& form, const FitData& data,
                           int reference) {
  return Contest(form, data).run(methods, reference);
}

bool is_success(double squares, double best) {
  constexpr double exact = 1e-12;  // 1e-10 % of E
  return squares <= std::max(1.001 * best, exact);
}

}  // namespace lrcs
