#include "view/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace lrcs {
namespace {

std::string with_typographic_minus(std::string text) {
  if (!text.empty() && text.front() == '-') text.replace(0, 1, "−");
  return text;
}

}  // namespace

double nice_step(double span, int most) {
  const double least = span / most;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * decade >= least) return digit * decade;
  }
  return 10.0 * decade;
}

double angle_step(double span_deg, int most) {
  if (span_deg / most <= 10.0) return nice_step(span_deg, most);
  for (const double step : {15.0, 30.0, 45.0, 90.0}) {
    if (step * most >= span_deg) return step;
  }
  return 180.0 * std::ceil(span_deg / most / 180.0);
}

std::vector<double> multiples(double low, double high, double step) {
  // A mark that rounding puts a hair outside the axis still belongs to it.
  constexpr double hair = 1e-9;  // [step]
  std::vector<double> found;
  const double last = std::floor(high / step + hair);
  for (double k = std::ceil(low / step - hair); k <= last; k += 1.0) found.push_back(k * step + 0.0);
  return found;
}

std::string tick_label(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (std::stod(text) == 0.0 && text.front() == '-') text.erase(0, 1);
  return with_typographic_minus(text);
}

std::string number_label(double value, int digits) {
  return with_typographic_minus(fmt::format("{:.{}g}", value, digits));
}

}  // namespace lrcs
