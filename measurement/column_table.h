#pragma once
#include <map>
#include <string>
#include <string_view>

#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/convention.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {

// What readers of tables with named columns share.

// Measurements by wavelength [m], shortest first.
using MeasurementsByWavelength = std::map<double, MeasurementBuilder>;

[[nodiscard]] MeasurementBuilder new_measurement(const std::string& file, const std::string& format,
                                                 const Convention& convention, double wavelength);

// error: InputError where there are none.
[[nodiscard]] Measurements finished(MeasurementsByWavelength& builders, const std::string& file);

// Calls take(scanner) at each line below this one that holds cells.
template <class Take>
void for_each_row(TextScanner& scanner, const Take& take) {
  while (scanner.next_line()) {
    if (holds_cells(scanner)) take(scanner);
  }
}

// Goes to the first line for which is(text of the line). False where there is none.
bool go_to_line(TextScanner& scanner, bool (*is)(std::string_view));

}  // namespace lrcs
