#include "fit/brdf_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/compensated_sum.h"
#include "base/input_error.h"
#include "brdf/brdf_form.h"
#include "fit/polish.h"
#include "fit/search.h"
#include "fit/uncertainty.h"

namespace lrcs {
namespace {

constexpr double least_f_r = 1e-150;  // [1/sr] the square of a smaller one is 0
constexpr double exact = 1e-24;       // squares below are rounding

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

// Evenly through the file, at most `count`.
std::vector<BrdfSample> thinned(const std::vector<BrdfSample>& samples, std::size_t count) {
  if (samples.size() <= count) return samples;
  std::vector<BrdfSample> few;
  few.reserve(count);
  for (std::size_t k = 0; k < count; ++k) few.push_back(samples[k * samples.size() / count]);
  return few;
}

Polished least_squares(std::string_view form, const std::vector<BrdfSample>& samples, const FitOptions& options);

// Five parameters with the empirical shadowing constants are a place among nine.
std::vector<Polished> contained_fits(std::string_view form, const std::vector<BrdfSample>& samples,
                                     const FitOptions& options) {
  if (form != forms::NineParameterForm::name) return {};
  Polished five = least_squares(forms::FiveParameterForm::name, samples, options);
  const WuParameters<double> empirical;
  five.parameters.insert(five.parameters.end(), {empirical.sigma_p, empirical.sigma_r, empirical.u_p, empirical.v_p});
  return {five};
}

// Sought among few of the samples, polished with all. A contained fit is polished with all in any case: few samples may
// prefer another place, where all have larger squares.
Polished least_squares(std::string_view form, const std::vector<BrdfSample>& samples, const FitOptions& options) {
  const auto contained = contained_fits(form, samples, options);
  std::vector<std::vector<double>> starts;
  for (const Polished& fit : contained) starts.push_back(fit.parameters);
  const auto few = thinned(samples, static_cast<std::size_t>(options.search_rows));
  const Polished sought = search(*fit_problem(form, 180, few, options.residual), options, starts);
  starts.push_back(sought.parameters);
  int evaluations = sought.evaluations;
  for (const Polished& fit : contained) evaluations += fit.evaluations;

  const auto problem = fit_problem(form, 180, samples, options.residual);
  Polished best;
  for (auto start = starts.rbegin(); start != starts.rend(); ++start) {
    const Polished down = descend(*problem, *start, {});
    const Polished end = polish(*problem, down.parameters);
    evaluations += down.evaluations + end.evaluations;
    if (best.parameters.empty() || end.squares < best.squares) best = end;
  }
  best.evaluations = evaluations;
  return best;
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

void set_parameters(BrdfFit& fit, const FitProblem& problem, const std::vector<double>& values) {
  const Uncertainty errors = uncertainty(problem, values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const FormParameter& p = problem.parameters()[k];
    const ParameterError95& e = errors.parameters[k];
    fit.parameters.push_back({std::string(p.name), std::string(p.meaning), values[k], e.standard_error, e.half_width,
                              e.determined, e.why_not});
  }
  fit.correlation = errors.correlation;
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
  const Polished found = least_squares(form_name, samples, options);
  const auto problem = fit_problem(form_name, 180, samples, options.residual);

  BrdfFit fit;
  fit.form = form.name;
  fit.material = {measurement.name, form.make(found.parameters, 180), measurement.wavelength, ""};
  set_parameters(fit, *problem, found.parameters);
  fit.e_percent = norm_e(fit.material.brdf, samples);
  fit.rms_logarithm = rms_logarithm(fit.material.brdf, samples);
  fit.samples = samples.size();
  const auto n = static_cast<double>(fit.samples);
  fit.criterion =
      n * std::log(std::max(found.squares, exact) / n) + static_cast<double>(form.parameters.size()) * std::log(n);
  fit.evaluations = found.evaluations;
  fit.seed = options.gsaa.seed;
  fit.converged = found.converged;
  fit.status = status_of(fit);
  fit.warnings = measurement.warnings;
  return fit;
}

}  // namespace lrcs
