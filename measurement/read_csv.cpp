#include <numbers>
#include <optional>
#include <string>

#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/comment_wavelength.h"
#include "measurement/convention.h"
#include "measurement/csv_header.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

bool next_data_row(TextScanner& scanner) {
  while (scanner.next_line()) {
    if (holds_cells(scanner)) return true;
  }
  return false;
}

void take_wavelength(const std::optional<Said<double>>& said, std::string_view content, MeasurementBuilder& builder) {
  if (said)
    builder.set_wavelength(said->value);
  else
    take_wavelength_of_comments(content, builder);
}

void read_rows(TextScanner& scanner, const Convention& convention, MeasurementBuilder& builder) {
  const std::vector<Column> columns = read_csv_columns(scanner);
  while (next_data_row(scanner)) {
    BrdfSample sample = read_row(scanner, columns, Separator::comma).sample_of(0);
    if (convention.azimuth_of_specular == 0) sample.phi += std::numbers::pi;
    builder.add(sample);
  }
}

}  // namespace

bool is_csv(std::string_view content) {
  TextScanner scanner(content, "");
  while (!holds_cells(scanner)) {
    if (!scanner.next_line()) return false;
  }
  const std::string line = lower_case(scanner.rest_of_line());
  if (line.find("theta") != std::string::npos || line.find("phi") != std::string::npos) return true;
  return begins_with_number(line) || line.find("f_r") != std::string::npos;
}

Measurements read_csv(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  TextScanner scanner(content, file);
  const CsvComments comments = read_csv_comments(scanner);
  const Convention convention = settled(comments.convention, options);
  MeasurementBuilder builder(file, "CSV");
  builder.set_angles_in_degrees();
  convention.apply(builder);
  take_wavelength(comments.wavelength, content, builder);
  if (holds_cells(scanner) || next_data_row(scanner)) read_rows(scanner, convention, builder);
  return {builder.finish()};
}

}  // namespace lrcs
