#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "measurement/convention.h"
#include "measurement/half_difference.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

constexpr std::size_t halves = 90;
constexpr std::size_t differences = 90;
constexpr std::size_t azimuths = 180;
constexpr std::size_t header_size = 12;
constexpr std::size_t file_size = header_size + 3 * halves * differences * azimuths * sizeof(double);
constexpr double red_scale = 1.0 / 1500.0;

std::array<std::int32_t, 3> dimensions_of(std::string_view content) {
  std::array<std::int32_t, 3> dimensions{};
  if (content.size() >= header_size) std::memcpy(dimensions.data(), content.data(), header_size);
  return dimensions;
}

double number_at(std::string_view content, std::size_t index) {
  double number = 0.0;
  std::memcpy(&number, content.data() + header_size + index * sizeof(double), sizeof(double));
  return number;
}

void require_finite(double value, std::size_t index, const std::string& file) {
  if (std::abs(value) <= 1e100) return;
  throw InputError(
      Place{file},
      fmt::format("value {} of the red channel is {}, expected a finite number of at most 1e100", index + 1, value));
}

// All values of one half angle and one difference angle.
void add_azimuths(std::string_view content, std::size_t i, std::size_t j, const std::string& file,
                  MeasurementBuilder& builder) {
  const double root = (static_cast<double>(i) + 0.5) / halves;
  const double theta_h = 90.0 * degree * root * root;
  const double theta_d = (static_cast<double>(j) + 0.5) * degree;
  for (std::size_t k = 0; k < azimuths; ++k) {
    const std::size_t index = (i * differences + j) * azimuths + k;
    const double value = number_at(content, index);
    require_finite(value, index, file);
    const auto [wi, wr] = directions_of_half_difference(theta_h, theta_d, (static_cast<double>(k) + 0.5) * degree);
    if (value < 0.0)
      builder.leave_out("below 0, not measured in this format,");
    else
      builder.add(wi, wr, value * red_scale, 0);
  }
}

void require_size(std::string_view content, const std::string& file) {
  if (content.size() == file_size) return;
  throw InputError(Place{file}, fmt::format("has {} bytes, expected the {} of a MERL file of 90 x 90 x 180 values",
                                            content.size(), file_size));
}

}  // namespace

bool is_merl(std::string_view content) {
  return dimensions_of(content) == std::array<std::int32_t, 3>{halves, differences, azimuths};
}

Measurements read_merl(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  require_size(content, file);
  MeasurementBuilder builder(file, "MERL");
  fixed(180, false, Place{file}, options).apply(builder);
  builder.note("the red channel was read, the nearest of the three to the infrared; the format states no wavelength");
  for (std::size_t i = 0; i < halves; ++i) {
    for (std::size_t j = 0; j < differences; ++j) add_azimuths(content, i, j, file, builder);
  }
  return {builder.finish()};
}

}  // namespace lrcs
