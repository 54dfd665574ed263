#include "measurement/measured_numbers.h"

#include <fmt/format.h>

#include <cmath>

#include "base/vec3.h"

namespace lrcs {
namespace {

constexpr double largest = 1e100;

double radians_in(AngleUnit unit) {
  return unit == AngleUnit::degrees ? degree : 1.0;
}

double angle(const TextScanner& scanner, std::string_view text, AngleUnit unit, double limit_deg,
             std::string_view what) {
  const double radians = measured_number(scanner, text) * radians_in(unit);
  if (std::abs(radians) <= limit_deg * degree + grazing_width) return radians;
  if (unit == AngleUnit::degrees)
    scanner.fail(fmt::format("expected {} of at most {} deg, found {}", what, limit_deg, shown(text)));
  scanner.fail(fmt::format("expected {} of at most {:.6g} rad, found {}", what, limit_deg * degree, shown(text)));
}

}  // namespace

double measured_number(const TextScanner& scanner, std::string_view text) {
  if (text.empty()) scanner.fail("expected a number, found nothing");
  const double number = scanner.number_in(text);
  if (!(std::abs(number) <= largest)) scanner.fail_expected("a number of at most 1e100", text);
  return number;
}

double zenith_angle(const TextScanner& scanner, std::string_view text, AngleUnit unit) {
  return angle(scanner, text, unit, 90.0, "an angle from the normal");
}

double azimuth_angle(const TextScanner& scanner, std::string_view text, AngleUnit unit) {
  return angle(scanner, text, unit, 720.0, "an azimuth");
}

double not_negative(const TextScanner& scanner, std::string_view text, std::string_view what) {
  const double number = measured_number(scanner, text);
  if (number < 0.0) scanner.fail(fmt::format("expected {} that is not negative, found {}", what, shown(text)));
  return number;
}

}  // namespace lrcs
