#include "measurement/measurement_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/input_error.h"
#include "measurement/measured_numbers.h"

namespace lrcs {
namespace {

using std::numbers::pi;

// To (-pi, pi]. -180 deg and what rounding makes of it is 180 deg.
double wrapped(double phi) {
  constexpr double rounding = 1e-12;
  phi = std::remainder(phi, 2.0 * pi);
  return pi - std::abs(phi) < rounding ? pi : phi;
}

bool is_grazing(double zenith) {
  return std::abs(zenith) >= pi / 2.0 - grazing_width;
}

double zenith_of(const Vec3& w) {
  return std::atan2(std::hypot(w.x(), w.y()), w.z());
}

double azimuth_of(const Vec3& w) {
  return std::atan2(w.y(), w.x());
}

// The middle one of the values; of an even number, the upper of two.
double median_f_r(const std::vector<BrdfSample>& samples) {
  std::vector<double> f_r;
  f_r.reserve(samples.size());
  for (const BrdfSample& s : samples) f_r.push_back(s.f_r);
  const auto middle = f_r.begin() + static_cast<std::ptrdiff_t>(f_r.size() / 2);
  std::nth_element(f_r.begin(), middle, f_r.end());
  return *middle;
}

}  // namespace

MeasurementBuilder::MeasurementBuilder(std::string file, std::string format) : file_(std::move(file)) {
  measurement_.name = std::filesystem::path(file_).filename().string();
  measurement_.format = std::move(format);
}

void MeasurementBuilder::Sizes::see(double angle) {
  constexpr double rounding = 1e-9;  // [deg] of degrees that went through radians
  const double size = std::abs(angle / degree);
  if (size < rounding) return;
  least = least > 0.0 ? std::min(least, size) : size;
  most = std::max(most, size);
  all_whole = all_whole && std::abs(size - std::round(size)) < rounding;
}

void MeasurementBuilder::add(BrdfSample sample) {
  phi_.see(sample.phi);
  put(sample);
}

void MeasurementBuilder::put(BrdfSample sample) {
  theta_i_.see(sample.theta_i);
  theta_r_.see(sample.theta_r);
  if (is_grazing(sample.theta_i) || is_grazing(sample.theta_r))
    return leave_out("at 90 deg from the normal, where the cosine is 0,");
  if ((sample.theta_i < 0.0) != (sample.theta_r < 0.0)) sample.phi += pi;
  sample.theta_i = std::abs(sample.theta_i);
  sample.theta_r = std::abs(sample.theta_r);
  sample.phi = wrapped(sample.phi);
  if (value_has_cosine_) sample.f_r /= std::cos(sample.theta_r);
  measurement_.samples.push_back(sample);
}

void MeasurementBuilder::add(const Vec3& wi, const Vec3& wr, double f_r, int line) {
  const double theta_i = zenith_of(wi);
  const double theta_r = zenith_of(wr);
  if (std::max(theta_i, theta_r) > pi / 2.0 + grazing_width) return leave_out("of directions below the surface,");
  put({theta_i, theta_r, azimuth_of(wr) - azimuth_of(wi), f_r, 1.0, line});
}

void MeasurementBuilder::leave_out(std::string_view why) {
  for (auto& [reason, count] : left_out_) {
    if (reason != why) continue;
    ++count;
    return;
  }
  left_out_.emplace_back(why, 1);
}

void MeasurementBuilder::note_what_is_left_out() {
  for (const auto& [why, count] : left_out_)
    note(fmt::format("{} {} {} left out", count, count == 1 ? "value" : "values", why));
}

void MeasurementBuilder::require_something_to_fit() const {
  const auto& samples = measurement_.samples;
  const Place place{file_};
  if (samples.empty() && left_out_.empty()) throw InputError(place, "holds no values, expected at least one");
  if (samples.empty()) {
    const auto& [why, count] = left_out_.front();
    throw InputError(place, fmt::format("has no value left to fit: {} {} left out", count, why));
  }
  const auto all_zero = [&](auto member) {
    return std::all_of(samples.begin(), samples.end(), [&](const BrdfSample& s) { return s.*member == 0.0; });
  };
  if (all_zero(&BrdfSample::f_r))
    throw InputError(place, fmt::format("all {} values of f_r are 0, nothing to fit", samples.size()));
  if (all_zero(&BrdfSample::weight))
    throw InputError(place, fmt::format("all {} weights are 0, nothing to fit", samples.size()));
}

// Each kind by itself: one column may have another unit than the next.
void MeasurementBuilder::warn_of_radians() {
  if (!angles_in_degrees_) return;
  const auto warn = [&](std::string_view name, const Sizes& sizes) {
    measurement_.warnings.push_back(
        fmt::format("no {} passes {:.3g} deg: look like radians, expected degrees", name, sizes.most));
  };
  const auto is_of_radians = [](const Sizes& zenith) { return zenith.most > zenith.least && zenith.most <= pi / 2.0; };
  if (is_of_radians(theta_i_)) warn("theta_i", theta_i_);
  if (is_of_radians(theta_r_)) warn("theta_r", theta_r_);
  if (!phi_.all_whole && phi_.most <= 2.0 * pi) warn("phi", phi_);
}

void MeasurementBuilder::warn_of_bright_surface() {
  constexpr double white = 1.2;
  const double reflectance = pi * median_f_r(measurement_.samples);
  if (reflectance <= white) return;
  measurement_.warnings.push_back(fmt::format(
      "pi times the median of f_r is {:.3g}, more than a white surface has: is the value relative to a white "
      "standard, or in percent?",
      reflectance));
}

BrdfMeasurement MeasurementBuilder::finish() {
  require_something_to_fit();
  note_what_is_left_out();
  warn_of_one_incidence(measurement_);
  warn_of_radians();
  warn_of_bright_surface();
  return std::move(measurement_);
}

}  // namespace lrcs
