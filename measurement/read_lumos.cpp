#include <array>
#include <vector>

#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/column_table.h"
#include "measurement/comment_wavelength.h"
#include "measurement/convention.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

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

}  // namespace

bool is_lumos(std::string_view content) {
  TextScanner scanner(content, "");
  return go_to_line(scanner, is_lumos_header);
}

Measurements read_lumos(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  TextScanner scanner(content, file);
  go_to_line(scanner, is_lumos_header);
  MeasurementBuilder builder = new_measurement(file, "table of phi_i, theta_i, phi_o, theta_o, brdf",
                                               fixed(180, false, scanner.place(), options), 0.0);
  builder.note("phi is the angle from the normal, theta the azimuth");
  take_wavelength_of_comments(content, builder);
  const std::vector columns{Column::theta_i, Column::azimuth_i, Column::theta_r, Column::azimuth_r, Column::value};
  for_each_row(scanner, [&](TextScanner& row) { builder.add(read_row(row, columns, Separator::blank).sample_of(0)); });
  return {builder.finish()};
}

}  // namespace lrcs
