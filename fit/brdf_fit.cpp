#include "fit/brdf_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/compensated_sum.h"
#include "base/input_error.h"
#include "brdf/brdf_form.h"
#include "fit/polish.h"
#include "fit/search.h"
#include "fit/uncertainty.h"

namespace lrcs {
namespace {

void require_enough(const BrdfMeasurement& measurement, const BrdfForm& form, Residual residual) {
  if (measurement.samples.size() < form.parameters.size())
    throw InputError(fmt::format("{}: {} samples, but {} has {} parameters", measurement.name,
                                 measurement.samples.size(), form.name, form.parameters.size()));
  if (residual == Residual::linear) return;
  for (const BrdfSample& s : measurement.samples)
    if (!(s.f_r > 0.0))
      throw InputError({measurement.name, s.line, 0}, "expected f_r > 0 for logarithmic residuals, found 0");
}

// Evenly through the file, at most `count`.
std::vector<BrdfSample> thinned(const std::vector<BrdfSample>& samples, std::size_t count) {
  if (samples.size() <= count) return samples;
  std::vector<BrdfSample> few;
  few.reserve(count);
  for (std::size_t k = 0; k < count; ++k) few.push_back(samples[k * samples.size() / count]);
  return few;
}

// Five parameters with the empirical shadowing constants are a place among nine.
std::vector<std::vector<double>> contained_fits(std::string_view form, const BrdfMeasurement& measurement,
                                                const FitOptions& options) {
  if (form != forms::NineParameterForm::name) return {};
  const BrdfFit five = fit_brdf(measurement, forms::FiveParameterForm::name, options);
  std::vector<double> start;
  for (const FittedParameter& p : five.parameters) start.push_back(p.value);
  const WuParameters<double> empirical;
  start.insert(start.end(), {empirical.sigma_p, empirical.sigma_r, empirical.u_p, empirical.v_p});
  return {start};
}

// The search's result; where it saw only some of the samples, what the best of its ends become with all of them.
Found found_in(const FitProblem& problem, const BrdfMeasurement& measurement, std::string_view form,
               const FitOptions& options) {
  const auto starts = contained_fits(form, measurement, options);
  const auto most = static_cast<std::size_t>(options.search_rows);
  if (measurement.samples.size() <= most) return search(problem, options, starts);
  const auto few = fit_problem(form, 180, thinned(measurement.samples, most), options.residual);
  Found found = search(*few, options, starts);
  constexpr std::size_t most_ends = 8;
  std::vector<std::vector<double>> ends = starts;
  for (std::size_t k = 0; k < std::min(most_ends, found.rivals.size()); ++k) ends.push_back(found.rivals[k].parameters);
  found.rivals.clear();
  constexpr Patience roughly{60, 1e-8};
  for (const auto& end : ends) found.rivals.push_back(descend(problem, end, roughly));
  std::stable_sort(found.rivals.begin(), found.rivals.end(),
                   [](const Polished& a, const Polished& b) { return a.squares < b.squares; });
  found.parameters = descend(problem, found.rivals.front().parameters, {}).parameters;
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
  require_enough(measurement, form, options.residual);
  const auto problem = fit_problem(form_name, 180, measurement.samples, options.residual);
  const Found sought = found_in(*problem, measurement, form_name, options);
  const Polished found = polish(*problem, sought.parameters);

  BrdfFit fit;
  fit.form = form.name;
  fit.material = {measurement.name, form.make(found.parameters, 180), measurement.wavelength, ""};
  set_parameters(fit, *problem, found.parameters, sought.rivals);
  fit.e_percent = norm_e(fit.material.brdf, measurement.samples);
  fit.rms_logarithm = rms_logarithm(fit.material.brdf, measurement.samples);
  fit.samples = measurement.samples.size();
  const auto n = static_cast<double>(fit.samples);
  fit.criterion = n * std::log(found.squares / n) + static_cast<double>(form.parameters.size()) * std::log(n);
  fit.evaluations = sought.evaluations + found.evaluations;
  fit.seed = options.gsaa.seed;
  fit.converged = found.converged;
  fit.status = status_of(fit);
  fit.warnings = measurement.warnings;
  return fit;
}

}  // namespace lrcs
