#include "fit/fit_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/length.h"
#include "base/version.h"

namespace lrcs {
namespace {

using Json = nlohmann::ordered_json;
constexpr double strong = 0.95;  // correlations from here on are said

std::string error_of(const FittedParameter& p) {
  return std::isfinite(p.standard_error) ? fmt::format("{:.2g}", p.standard_error) : "-";
}

std::string correlations(const BrdfFit& fit) {
  std::vector<std::string> pairs;
  for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (std::abs(fit.correlation(i, j)) >= strong)
        pairs.push_back(fmt::format("{} and {} {:+.3f}", fit.parameters[static_cast<std::size_t>(j)].name,
                                    fit.parameters[static_cast<std::size_t>(i)].name, fit.correlation(i, j)));
  return pairs.empty() ? "" : fmt::format("correlated: {}\n", fmt::join(pairs, ", "));
}

std::string parameters_in_a_row(const BrdfFit& fit) {
  std::string text;
  for (const FittedParameter& p : fit.parameters)
    text += fmt::format(" {}={:.4g}{}", p.name, p.value, p.determined ? "" : "?");
  return text;
}

Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json parameters_json(const BrdfFit& fit) {
  Json parameters = Json::object();
  for (const FittedParameter& p : fit.parameters) {
    Json& entry = parameters[p.name];
    entry["value"] = p.value;
    entry["standard_error"] = number(p.standard_error);
    entry["interval_95"] = {number(p.value - p.half_width_95), number(p.value + p.half_width_95)};
    entry["determined"] = p.determined;
    if (!p.determined) entry["reason"] = p.why_not;
    entry["meaning"] = p.meaning;
  }
  return parameters;
}

Json correlation_json(const BrdfFit& fit) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < fit.correlation.cols(); ++j) row.push_back(number(fit.correlation(i, j)));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::string fit_text(const BrdfFit& fit) {
  std::string text =
      fmt::format("{} fitted to {} ({} samples{})\n", fit.form, fit.material.name, fit.samples,
                  fit.material.wavelength > 0.0 ? ", wavelength " + text_of_length(fit.material.wavelength, "um")
                                                : ", wavelength not stated");
  text +=
      fmt::format("E = {:.5g} %, root mean square of ln(model/measured) {:.3g}\n", fit.e_percent, fit.rms_logarithm);
  text += fmt::format("{:<12} {:>12} {:>10}\n", "parameter", "value", "std. error");
  for (const FittedParameter& p : fit.parameters)
    text += fmt::format("{:<12} {:>12.6g} {:>10}  {}{}\n", p.name, p.value, error_of(p), p.meaning,
                        p.determined ? "" : "; not determined: " + p.why_not);
  text += correlations(fit);
  return text + fmt::format("{} evaluations, seed {}: {}\n", fit.evaluations, fit.seed, fit.status);
}

std::string comparison_text(const std::vector<BrdfFit>& fits) {
  std::vector<const BrdfFit*> order;
  order.reserve(fits.size());
  for (const BrdfFit& fit : fits) order.push_back(&fit);
  std::stable_sort(order.begin(), order.end(),
                   [](const BrdfFit* a, const BrdfFit* b) { return a->criterion < b->criterion; });
  std::string text =
      fmt::format("{:<23} {:>10} {:>8} {:>10}  parameters (?: not determined)\n", "model", "E [%]", "rms ln", "BIC");
  for (const BrdfFit* fit : order)
    text += fmt::format("{:<23} {:>10.4g} {:>8.3g} {:>10.1f} {}\n", fit->form, fit->e_percent, fit->rms_logarithm,
                        fit->criterion, parameters_in_a_row(*fit));
  return text;
}

std::string fit_json(const BrdfFit& fit, const BrdfMeasurement& measurement) {
  const Json json{{"model", fit.form},
                  {"e_percent", fit.e_percent},
                  {"rms_logarithm", number(fit.rms_logarithm)},
                  {"criterion", number(fit.criterion)},
                  {"parameters", parameters_json(fit)},
                  {"correlation", correlation_json(fit)},
                  {"samples", fit.samples},
                  {"evaluations", fit.evaluations},
                  {"seed", fit.seed},
                  {"converged", fit.converged},
                  {"status", fit.status},
                  {"warnings", fit.warnings},
                  {"data", measurement.name},
                  {"format", measurement.format},
                  {"notes", measurement.notes},
                  {"wavelength_m", measurement.wavelength > 0.0 ? Json(measurement.wavelength) : Json(nullptr)},
                  {"azimuth_of_specular", 180},
                  {"version", version}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";  // a file's name may be no UTF-8
}

}  // namespace lrcs
