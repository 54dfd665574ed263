#include "fit/brdf_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "base/compensated_sum.h"
#include "base/input_error.h"
#include "brdf/brdf_form.h"
#include "fit/polish.h"
#include "fit/search.h"
#include "fit/thinned.h"
#include "fit/uncertainty.h"

namespace lrcs {
namespace {

constexpr double least_f_r = 1e-150;  // [1/sr] the square of a smaller one is 0

// A sample of weight 0 says nothing, not even that it is there.
std::vector<BrdfSample> weighed(const std::vector<BrdfSample>& samples) {
  std::vector<BrdfSample> some;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(some),
               [](const BrdfSample& s) { return s.weight > 0.0; });
  return some;
}

void require_enough(const std::string& name, const std::vector<BrdfSample>& samples, const BrdfForm& form,
                    Residual residual) {
  if (samples.size() < form.parameters.size())
    throw InputError(fmt::format("{}: {} samples, but {} has {} parameters", name, samples.size(), form.name,
                                 form.parameters.size()));
  if (std::none_of(samples.begin(), samples.end(), [](const BrdfSample& s) { return s.f_r > least_f_r; }))
    throw InputError(fmt::format("{}: no f_r above {} in the {} samples that count, nothing to fit", name, least_f_r,
                                 samples.size()));
  if (residual == Residual::linear) return;
  for (const BrdfSample& s : samples)
    if (!(s.f_r > 0.0)) throw InputError({name, s.line, 0}, "expected f_r > 0 for logarithmic residuals, found 0");
}

Found least_squares(const FitProblem& problem, std::string_view form, const std::vector<BrdfSample>& samples,
                    const FitOptions& options);

// Five parameters with the empirical shadowing constants are a place among nine.
std::vector<Polished> contained_fits(std::string_view form, const std::vector<BrdfSample>& samples,
                                     const FitOptions& options) {
  if (form != forms::NineParameterForm::name) return {};
  const auto name = forms::FiveParameterForm::name;
  Polished five = least_squares(*fit_problem(name, 180, samples, options.residual), name, samples, options);
  const WuParameters<double> empirical;
  five.parameters.insert(five.parameters.end(), {empirical.sigma_p, empirical.sigma_r, empirical.u_p, empirical.v_p});
  return {five};
}

// What was found with few of the samples, seen by all: the best of the ends, and the starts, descend once more. Few may
// prefer another place, where all have larger squares.
void descend_with_all(const FitProblem& problem, const std::vector<std::vector<double>>& starts, Found& found) {
  constexpr std::size_t most_ends = 8;
  constexpr Patience roughly{60, 1e-8};
  std::vector<std::vector<double>> ends = starts;
  for (std::size_t k = 0; k < std::min(most_ends, found.rivals.size()); ++k) ends.push_back(found.rivals[k].parameters);
  found.rivals.clear();
  for (const auto& end : ends) {
    found.rivals.push_back(descend(problem, end, roughly));
    found.evaluations += found.rivals.back().evaluations;
  }
  std::stable_sort(found.rivals.begin(), found.rivals.end(),
                   [](const Polished& a, const Polished& b) { return a.squares < b.squares; });
  const Polished best = descend(problem, found.rivals.front().parameters, {});
  found.parameters = best.parameters;
  found.evaluations += best.evaluations;
}

// The last polish; where it gives up in a narrow valley, from there on again.
void finish(const FitProblem& problem, Found& found) {
  constexpr int most_rounds = 2;
  found.converged = false;
  for (int round = 0; round < most_rounds && !found.converged; ++round) {
    const Polished start = round == 0 ? static_cast<Polished>(found) : descend(problem, found.parameters, {});
    const Polished end = polish(problem, start.parameters);
    found.parameters = end.parameters;
    found.squares = end.squares;
    found.evaluations += (round == 0 ? 0 : start.evaluations) + end.evaluations;
    found.converged = is_least(problem, found.parameters);
  }
}

// Sought among few of the samples, polished with all.
Found least_squares(const FitProblem& problem, std::string_view form, const std::vector<BrdfSample>& samples,
                    const FitOptions& options) {
  const auto contained = contained_fits(form, samples, options);
  std::vector<std::vector<double>> starts;
  starts.reserve(contained.size());
  for (const Polished& fit : contained) starts.push_back(fit.parameters);
  const auto most = static_cast<std::size_t>(options.search_rows);
  Found found;
  if (samples.size() <= most) {
    found = search(problem, options, starts);
  } else {
    found =
        search(*fit_problem(form, 180, thinned(samples, most, options.gsaa.seed), options.residual), options, starts);
    descend_with_all(problem, starts, found);
  }
  finish(problem, found);
  for (const Polished& fit : contained) found.evaluations += fit.evaluations;
  return found;
}

double rms_logarithm(const Brdf& brdf, const std::vector<BrdfSample>& samples) {
  CompensatedSum squares;
  double count = 0.0;
  for (const BrdfSample& s : samples) {
    const double f = f_r_angles(brdf, s.theta_i, s.theta_r, s.phi);
    if (!(f > 0.0) || !(s.f_r > 0.0)) continue;
    squares.add(std::pow(std::log(f / s.f_r), 2.0));
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares.value() / count) : 0.0;
}

void set_parameters(BrdfFit& fit, const FitProblem& problem, const std::vector<double>& values,
                    const std::vector<Polished>& rivals) {
  const Uncertainty errors = uncertainty(problem, values, rivals);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const FormParameter& p = problem.parameters()[k];
    const ParameterError95& e = errors.parameters[k];
    fit.parameters.push_back({std::string(p.name), std::string(p.meaning), values[k], e.standard_error, e.half_width,
                              e.determined, e.why_not});
  }
  fit.correlation = errors.correlation;
}

// How few samples make up half of what E is measured in.
std::size_t half_of_the_signal(const std::vector<BrdfSample>& samples) {
  std::vector<double> squares;
  squares.reserve(samples.size());
  for (const BrdfSample& s : samples) squares.push_back(s.weight * std::pow(s.f_r * std::cos(s.theta_r), 2.0));
  std::sort(squares.begin(), squares.end(), std::greater<>());
  const double half = 0.5 * std::accumulate(squares.begin(), squares.end(), 0.0);
  std::size_t count = 0;
  for (double sum = 0.0; sum < half; ++count) sum += squares[count];
  return count;
}

// A lobe that is narrower than the steps between samples.
void warn_of_few(const std::vector<BrdfSample>& samples, std::vector<std::string>& warnings) {
  constexpr std::size_t few = 5;
  const std::size_t count = half_of_the_signal(samples);
  if (count <= few && 20 * count <= samples.size())
    warnings.push_back(
        fmt::format("{} of {} samples hold half of what E weighs: the lobe is hardly sampled, its "
                    "shape and what lies off it are not to be trusted (--residual log weighs decades "
                    "alike)",
                    count, samples.size()));
}

std::string status_of(const BrdfFit& fit) {
  std::string undetermined;
  for (const FittedParameter& p : fit.parameters)
    if (!p.determined) undetermined += (undetermined.empty() ? "" : ", ") + p.name;
  const std::string status = fit.converged ? "converged" : "not converged";
  return undetermined.empty() ? status : fmt::format("{}; the data do not determine {}", status, undetermined);
}

}  // namespace

double norm_e(const Brdf& brdf, const std::vector<BrdfSample>& samples) {
  CompensatedSum difference, all;
  for (const BrdfSample& s : samples) {
    const double cosine = std::cos(s.theta_r);
    const double measured = s.f_r * cosine;
    difference.add(s.weight * std::pow(f_r_angles(brdf, s.theta_i, s.theta_r, s.phi) * cosine - measured, 2.0));
    all.add(s.weight * measured * measured);
  }
  return 100.0 * difference.value() / all.value();
}

BrdfFit fit_brdf(const BrdfMeasurement& measurement, std::string_view form_name, const FitOptions& options) {
  const BrdfForm& form = *find_brdf_form(form_name);
  const auto samples = weighed(measurement.samples);
  require_enough(measurement.name, samples, form, options.residual);
  const auto problem = fit_problem(form_name, 180, samples, options.residual);
  const Found found = least_squares(*problem, form_name, samples, options);

  BrdfFit fit;
  fit.form = form.name;
  fit.material = {measurement.name, form.make(found.parameters, 180), measurement.wavelength, ""};
  set_parameters(fit, *problem, found.parameters, found.rivals);
  fit.e_percent = norm_e(fit.material.brdf, samples);
  fit.rms_logarithm = rms_logarithm(fit.material.brdf, samples);
  fit.samples = samples.size();
  const auto n = static_cast<double>(fit.samples);
  fit.criterion = n * std::log(std::max(found.squares, rounding_of_squares) / n) +
                  static_cast<double>(form.parameters.size()) * std::log(n);
  fit.evaluations = found.evaluations;
  fit.seed = options.gsaa.seed;
  fit.converged = found.converged;
  fit.status = status_of(fit);
  fit.warnings = measurement.warnings;
  if (options.residual == Residual::linear) warn_of_few(samples, fit.warnings);
  return fit;
}

}  // namespace lrcs
