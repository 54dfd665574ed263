#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/length.h"
#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/comment_wavelength.h"
#include "measurement/convention.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

// Measurements by wavelength [m], shortest first.
using Builders = std::map<double, MeasurementBuilder>;

MeasurementBuilder new_builder(const std::string& file, const std::string& format, const Convention& convention,
                               double wavelength) {
  MeasurementBuilder builder(file, format);
  builder.set_angles_in_degrees();
  builder.set_wavelength(wavelength);
  convention.apply(builder);
  return builder;
}

Measurements finished(Builders& builders, const std::string& file) {
  Measurements measurements;
  for (auto& [wavelength, builder] : builders) measurements.push_back(builder.finish());
  if (measurements.empty()) throw InputError(Place{file}, "holds no values, expected at least one row of them");
  return measurements;
}

// Calls take(scanner) at each line below this one that holds cells.
template <class Take>
void for_each_row(TextScanner& scanner, const Take& take) {
  while (scanner.next_line()) {
    if (holds_cells(scanner)) take(scanner);
  }
}

// Goes to the first line that is(text of the line). False where there is none.
template <class Is>
bool go_to_line(TextScanner& scanner, const Is& is) {
  do {
    TextScanner ahead = scanner;
    if (is(ahead.rest_of_line())) return true;
  } while (scanner.next_line());
  return false;
}

// "# phi_i theta_i phi_o theta_o brdf": phi is the zenith, theta the azimuth.
bool is_lumos_header(std::string_view line) {
  constexpr std::array<std::array<std::string_view, 2>, 5> names{
      {{"phi_i", "phi_in"}, {"theta_i", "theta_in"}, {"phi_o", "phi_out"}, {"theta_o", "theta_out"}, {"brdf", "brdf"}}};
  if (!line.starts_with('#')) return false;
  TextScanner words(line.substr(1), "");
  for (const auto& name : names) {
    const std::string_view word = words.word();
    if (word != name[0] && word != name[1]) return false;
  }
  return words.word().empty();
}

Measurements read_lumos(TextScanner scanner, std::string_view content, const std::string& file,
                        const MeasurementOptions& options) {
  MeasurementBuilder builder = new_builder(file, "table of phi_i, theta_i, phi_o, theta_o, brdf",
                                           fixed(180, false, scanner.place(), options), 0.0);
  builder.note("phi is the angle from the normal, theta the azimuth");
  take_wavelength_of_comments(content, builder);
  const std::vector columns{Column::theta_i, Column::azimuth_i, Column::theta_r, Column::azimuth_r, Column::value};
  for_each_row(scanner, [&](TextScanner& row) { builder.add(read_row(row, columns, Separator::blank).sample_of(0)); });
  return {builder.finish()};
}

bool is_nist_header(std::string_view line) {
  return line.starts_with("lambda,thetai,phi") && line.find("11") != std::string_view::npos;
}

std::vector<Column> nist_columns(TextScanner& scanner) {
  constexpr std::array<std::array<std::string_view, 2>, 6> names{{{"lambda", "lambda"},
                                                                  {"thetai", "thetai"},
                                                                  {"phi", "phii"},
                                                                  {"thetar", "thetar"},
                                                                  {"phir", "phir"},
                                                                  {"f_r11", "fr11"}}};
  for (const auto& name : names) {
    const std::string_view cell = scanner.cell().value_or("");
    if (cell != name[0] && cell != name[1]) scanner.fail_expected(fmt::format("a column '{}'", name[0]), cell);
  }
  std::vector columns{Column::wavelength_um, Column::theta_i,   Column::azimuth_i,
                      Column::theta_r,       Column::azimuth_r, Column::value};
  while (scanner.cell()) columns.push_back(Column::ignored);
  return columns;
}

Measurements read_nist(TextScanner scanner, const std::string& file, const MeasurementOptions& options) {
  const std::vector<Column> columns = nist_columns(scanner);
  const Convention convention = fixed(180, false, scanner.place(), options);
  Builders builders;
  for_each_row(scanner, [&](TextScanner& line) {
    const ColumnRow row = read_row(line, columns, Separator::comma);
    auto found = builders.find(row.wavelength);
    if (found == builders.end()) {
      found = builders
                  .emplace(row.wavelength, new_builder(file, "table of lambda, thetai, phi, thetar, phir, f_r11",
                                                       convention, row.wavelength))
                  .first;
      found->second.note("f_r11 is read, the value for unpolarised light");
    }
    found->second.add(row.sample_of(0));
  });
  return finished(builders, file);
}

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
    wavelengths.push_back(wavelength_of_heading(scanner, word));
    if (std::count(wavelengths.begin(), wavelengths.end(), wavelengths.back()) > 1)
      scanner.fail(fmt::format("a second column '{}', expected one", shown(word)));
  }
  if (wavelengths.empty()) scanner.fail("expected columns headed by wavelengths, such as 1064nm, found none");
  return wavelengths;
}

Measurements read_factors(TextScanner scanner, const std::string& file, const MeasurementOptions& options) {
  const std::vector<double> wavelengths = factor_wavelengths(scanner);
  Convention convention = fixed(180, false, scanner.place(), options);
  convention.value_note = "value: reflectance factor (BRF), divided by pi (the file says so)";
  Builders builders;
  for (const double w : wavelengths)
    builders.emplace(w, new_builder(file, "table of reflectance factors", convention, w));
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

}  // namespace

bool is_columns(std::string_view content) {
  TextScanner scanner(content, "");
  return go_to_line(scanner, [](std::string_view line) {
    return is_lumos_header(line) || is_nist_header(line) || is_factor_header(line);
  });
}

Measurements read_columns(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  TextScanner scanner(content, file);
  if (go_to_line(scanner, is_lumos_header)) return read_lumos(scanner, content, file, options);
  scanner = TextScanner(content, file);
  if (go_to_line(scanner, is_nist_header)) return read_nist(scanner, file, options);
  scanner = TextScanner(content, file);
  go_to_line(scanner, is_factor_header);
  return read_factors(scanner, file, options);
}

}  // namespace lrcs
