#include "base/length.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/nearest_name.h"

namespace lrcs {
namespace {

struct Unit {
  std::string_view name;
  double metres;
  std::optional<int> power_of_ten;  // metres = 10^power_of_ten
};

constexpr std::array<Unit, 13> units{{{"nm", 1e-9, -9},
                                      {"um", 1e-6, -6},
                                      {"mm", 1e-3, -3},
                                      {"cm", 1e-2, -2},
                                      {"dm", 1e-1, -1},
                                      {"m", 1.0, 0},
                                      {"km", 1e3, 3},
                                      {"inch", 0.0254, std::nullopt},
                                      {"in", 0.0254, std::nullopt},
                                      {"ft", 0.3048, std::nullopt},
                                      {"mil", 2.54e-5, std::nullopt},
                                      {"\u00b5m", 1e-6, -6},    // micro sign
                                      {"\u03bcm", 1e-6, -6}}};  // Greek mu
constexpr std::size_t listed = 11;                              // the two above are spellings, not units to list

const Unit& unit_of(std::string_view name) {
  const auto* found = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name; });
  if (found == units.end())
    throw std::invalid_argument(fmt::format("unknown length unit '{}'{} (known: {})", name,
                                            did_you_mean(name, length_units()), fmt::join(length_units(), ", ")));
  return *found;
}

std::optional<double> double_of(std::string_view digits) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

// The decimal number times 10^shift, rounded once: the exponent is changed in the text.
std::optional<double> shifted(std::string_view digits, int shift) {
  const auto e = digits.find_first_of("eE");
  int exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view tail = digits.substr(e + 1);
    if (tail.starts_with('+')) tail.remove_prefix(1);
    const auto [end, error] = std::from_chars(tail.data(), tail.data() + tail.size(), exponent);
    if (error != std::errc{} || end != tail.data() + tail.size()) return std::nullopt;
    if (std::abs(exponent) > 1000) return std::nullopt;
  }
  return double_of(fmt::format("{}e{}", digits.substr(0, e), exponent + shift));
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

[[noreturn]] void not_a_length(std::string_view text) {
  throw std::invalid_argument(
      fmt::format("expected a positive length with its unit, such as '1.06 um', found '{}'", text));
}

}  // namespace

const std::vector<std::string>& length_units() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (std::size_t k = 0; k < listed; ++k) all.emplace_back(units[k].name);
    return all;
  }();
  return names;
}

double metres_in(std::string_view unit) {
  return unit_of(unit).metres;
}

double length_from_text(std::string_view text) {
  std::string_view digits = trimmed(text);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double number = 0.0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (parsed.ec == std::errc::invalid_argument || !std::isfinite(number) || digits.starts_with('-')) not_a_length(text);
  const auto count = static_cast<std::size_t>(parsed.ptr - digits.data());
  const std::string_view name = trimmed(digits.substr(count));
  if (name.empty()) not_a_length(text);
  const Unit& unit = unit_of(name);
  digits = digits.substr(0, count);
  const auto metres = unit.power_of_ten ? shifted(digits, *unit.power_of_ten) : double_of(digits);
  const double length = metres.value_or(0.0) * (unit.power_of_ten ? 1.0 : unit.metres);
  if (!(length > 0.0) || !std::isfinite(length)) not_a_length(text);
  return length;
}

std::string text_of_length(double metres, std::string_view unit) {
  const double in_unit = metres / metres_in(unit);
  for (int digits = 1; digits <= 17; ++digits) {
    std::string text = fmt::format("{:.{}g} {}", in_unit, digits, unit);
    if (length_from_text(text) == metres) return text;
  }
  return fmt::format("{} m", metres);
}

}  // namespace lrcs
