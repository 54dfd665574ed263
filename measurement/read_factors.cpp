#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "base/length.h"
#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/column_table.h"
#include "measurement/convention.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

bool is_factor_header(std::string_view line) {
  return line.starts_with("src_z");
}

double wavelength_of_heading(const TextScanner& scanner, std::string_view heading) {
  try {
    return length_from_text(heading);
  } catch (const std::invalid_argument&) {
    scanner.fail_expected("a wavelength such as 1064nm as a column's name", heading);
  }
}

// The wavelengths that head the columns of reflectance factors, in file order.
std::vector<double> factor_wavelengths(TextScanner& scanner) {
  for (const std::string_view name : {"src_z", "src_a", "view_z", "view_a"}) {
    const std::string_view word = scanner.word();
    if (word != name) scanner.fail_expected(fmt::format("a column '{}'", name), word);
  }
  std::vector<double> wavelengths;
  for (auto word = scanner.word(); !word.empty(); word = scanner.word()) {
    if (wavelengths.size() == most_columns)
      scanner.fail(fmt::format("expected at most {} columns, found more", most_columns));
    wavelengths.push_back(wavelength_of_heading(scanner, word));
    if (std::count(wavelengths.begin(), wavelengths.end(), wavelengths.back()) > 1)
      scanner.fail(fmt::format("a second column '{}', expected one", shown(word)));
  }
  if (wavelengths.empty()) scanner.fail("expected columns headed by wavelengths, such as 1064nm, found none");
  return wavelengths;
}

}  // namespace

bool is_factors(std::string_view content) {
  TextScanner scanner(content, "");
  return go_to_line(scanner, is_factor_header);
}

Measurements read_factors(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  TextScanner scanner(content, file);
  go_to_line(scanner, is_factor_header);
  const std::vector<double> wavelengths = factor_wavelengths(scanner);
  Convention convention = fixed(180, false, scanner.place(), options);
  convention.value_note = "value: reflectance factor (BRF), divided by pi (the file says so)";
  MeasurementsByWavelength builders;
  for (const double w : wavelengths)
    builders.emplace(w, new_measurement(file, "table of reflectance factors", convention, w));
  std::vector columns{Column::theta_i, Column::azimuth_i, Column::theta_r, Column::azimuth_r};
  columns.insert(columns.end(), wavelengths.size(), Column::value);
  for_each_row(scanner, [&](TextScanner& line) {
    const ColumnRow row = read_row(line, columns, Separator::blank);
    for (std::size_t k = 0; k < wavelengths.size(); ++k) {
      BrdfSample sample = row.sample_of(k);
      sample.f_r /= std::numbers::pi;
      builders.at(wavelengths[k]).add(sample);
    }
  });
  return finished(builders, file);
}

}  // namespace lrcs
