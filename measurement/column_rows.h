#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "base/text_scanner.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

// What a column of a table of measured values holds. Angles are in degrees.
enum class Column { ignored, wavelength_um, theta_i, azimuth_i, theta_r, azimuth_r, value, weight };

inline constexpr std::size_t most_columns = 1000;

enum class Separator { comma, blank };

// One row, as the file states it.
struct ColumnRow {
  double wavelength = 0.0;     // [m]
  double azimuth_i = 0.0;      // [rad]
  double azimuth_r = 0.0;      // [rad]
  BrdfSample sample;           // all but phi and f_r; zeniths of any sign
  std::vector<double> values;  // in the order of their columns, not negative

  // The sample with the k-th value as f_r.
  [[nodiscard]] BrdfSample sample_of(std::size_t k) const;
};

// The next cell of this line; nothing at its end.
[[nodiscard]] std::optional<std::string_view> next_cell(TextScanner& scanner, Separator separator);

// The line holds more than blanks and a comment. Takes nothing.
[[nodiscard]] bool holds_cells(TextScanner ahead);

// error: InputError at the cell that is wrong, or where the row has more or fewer cells than columns.
[[nodiscard]] ColumnRow read_row(TextScanner& scanner, const std::vector<Column>& columns, Separator separator);

}  // namespace lrcs
