#include <fmt/format.h>

#include <array>
#include <vector>

#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/column_table.h"
#include "measurement/convention.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

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

MeasurementBuilder new_nist_measurement(const std::string& file, const Convention& convention, double wavelength) {
  MeasurementBuilder builder =
      new_measurement(file, "table of lambda, thetai, phi, thetar, phir, f_r11", convention, wavelength);
  builder.note("f_r11 is read, the value for unpolarised light");
  return builder;
}

}  // namespace

bool is_nist(std::string_view content) {
  TextScanner scanner(content, "");
  return go_to_line(scanner, is_nist_header);
}

Measurements read_nist(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  TextScanner scanner(content, file);
  go_to_line(scanner, is_nist_header);
  const std::vector<Column> columns = nist_columns(scanner);
  const Convention convention = fixed(180, false, scanner.place(), options);
  MeasurementsByWavelength builders;
  for_each_row(scanner, [&](TextScanner& line) {
    const ColumnRow row = read_row(line, columns, Separator::comma);
    auto found = builders.find(row.wavelength);
    if (found == builders.end()) {
      if (builders.size() == most_columns) line.fail(fmt::format("expected at most {} wavelengths", most_columns));
      found = builders.emplace(row.wavelength, new_nist_measurement(file, convention, row.wavelength)).first;
    }
    found->second.add(row.sample_of(0));
  });
  return finished(builders, file);
}

}  // namespace lrcs
