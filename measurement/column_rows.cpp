#include "measurement/column_rows.h"

#include <fmt/format.h>

#include "base/length.h"
#include "measurement/measured_numbers.h"

namespace lrcs {
namespace {

double wavelength_of_cell(const TextScanner& scanner, std::string_view text) {
  const double um = measured_number(scanner, text);
  if (um <= 0.0 || um > 1000.0)
    scanner.fail(fmt::format("expected a wavelength in um, up to 1000, found {}", shown(text)));
  return length_from_text(fmt::format("{} um", um));
}

void take(const TextScanner& scanner, std::string_view text, Column column, ColumnRow& row) {
  switch (column) {
    case Column::ignored:
      return;
    case Column::wavelength_um:
      row.wavelength = wavelength_of_cell(scanner, text);
      return;
    case Column::theta_i:
      row.sample.theta_i = zenith_angle(scanner, text, AngleUnit::degrees);
      return;
    case Column::azimuth_i:
      row.azimuth_i = azimuth_angle(scanner, text, AngleUnit::degrees);
      return;
    case Column::theta_r:
      row.sample.theta_r = zenith_angle(scanner, text, AngleUnit::degrees);
      return;
    case Column::azimuth_r:
      row.azimuth_r = azimuth_angle(scanner, text, AngleUnit::degrees);
      return;
    case Column::value:
      row.values.push_back(not_negative(scanner, text, "a value"));
      return;
    case Column::weight:
      row.sample.weight = not_negative(scanner, text, "a weight");
      return;
  }
}

}  // namespace

BrdfSample ColumnRow::sample_of(std::size_t k) const {
  BrdfSample all = sample;
  all.phi = azimuth_r - azimuth_i;
  all.f_r = values[k];
  return all;
}

std::optional<std::string_view> next_cell(TextScanner& scanner, Separator separator) {
  if (separator == Separator::comma) return scanner.cell();
  const std::string_view word = scanner.word();
  return word.empty() ? std::nullopt : std::optional(word);
}

bool holds_cells(TextScanner ahead) {
  return !ahead.word().empty();
}

ColumnRow read_row(TextScanner& scanner, const std::vector<Column>& columns, Separator separator) {
  ColumnRow row;
  row.sample.line = scanner.line();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto text = next_cell(scanner, separator);
    if (!text) scanner.fail(fmt::format("expected {} cells as in the header, found {}", columns.size(), k));
    take(scanner, *text, columns[k], row);
  }
  if (next_cell(scanner, separator))
    scanner.fail(fmt::format("expected {} cells as in the header, found more", columns.size()));
  return row;
}

}  // namespace lrcs
