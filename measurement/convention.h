#pragma once
#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "base/input_error.h"
#include "base/text_scanner.h"
#include "measurement/brdf_measurement.h"
#include "measurement/measurement_builder.h"

namespace lrcs {

// A thing that a file says, and where.
template <class T>
struct Said {
  T value;
  Place place;
};

// Takes what is said where `scanner` is. error: InputError where another line said otherwise.
template <class T>
void take_said(std::optional<Said<T>>& said, T value, const TextScanner& scanner, std::string_view key) {
  if (said && said->value != value)
    scanner.fail(fmt::format("line {} says another {}, expected one", said->place.line, key));
  if (!said) said = Said<T>{value, scanner.place()};
}

// What a file says of its convention.
struct SaidConvention {
  std::optional<Said<int>> azimuth_of_specular;  // [deg]
  std::optional<Said<bool>> value_has_cosine;
};

// The convention that holds: the file's, else the one asked for, else the default.
struct Convention {
  int azimuth_of_specular = 180;  // [deg]
  bool value_has_cosine = false;
  std::string azimuth_note;
  std::string value_note;

  // Tells the builder.
  void apply(MeasurementBuilder& builder) const;
};

// error: InputError where file and options differ, at the place where the file speaks.
[[nodiscard]] Convention settled(const SaidConvention& said, const MeasurementOptions& options);

// The convention of a format that fixes it. `place` of what shows the format.
[[nodiscard]] Convention fixed(int azimuth_of_specular, bool value_has_cosine, const Place& place,
                               const MeasurementOptions& options);

}  // namespace lrcs
