#include "measurement/column_table.h"

namespace lrcs {

MeasurementBuilder new_measurement(const std::string& file, const std::string& format, const Convention& convention,
                                   double wavelength) {
  MeasurementBuilder builder(file, format);
  builder.set_angles_in_degrees();
  builder.set_wavelength(wavelength);
  convention.apply(builder);
  return builder;
}

Measurements finished(MeasurementsByWavelength& builders, const std::string& file) {
  Measurements measurements;
  for (auto& [wavelength, builder] : builders) measurements.push_back(builder.finish());
  if (measurements.empty()) throw InputError(Place{file}, "holds no values, expected at least one row of them");
  return measurements;
}

bool go_to_line(TextScanner& scanner, bool (*is)(std::string_view)) {
  do {
    TextScanner ahead = scanner;
    if (is(ahead.rest_of_line())) return true;
  } while (scanner.next_line());
  return false;
}

}  // namespace lrcs
