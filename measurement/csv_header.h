#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/convention.h"

namespace lrcs {

// What the comments of our CSV say: "# wavelength: 1.06 um", "# azimuth_of_specular: 180 | 0", "# value: brdf |
// brdf_cosine". Comments with other keys are words for people.
struct CsvComments {
  SaidConvention convention;
  std::optional<Said<double>> wavelength;  // [m]
};

// Those from this line to the file's end. error: InputError for a value that is none, for two different ones, and for a
// key that is nearly one of the three.
[[nodiscard]] CsvComments read_csv_comments(TextScanner scanner);

// Takes the row of names: what each column holds. Case does not matter.
// error: InputError for a name that is missing, stands twice, is nearly right or has another unit.
[[nodiscard]] std::vector<Column> read_csv_columns(TextScanner& scanner);

// A line that begins like a number.
[[nodiscard]] bool begins_with_number(std::string_view line);

[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace lrcs
