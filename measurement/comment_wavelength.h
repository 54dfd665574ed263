#pragma once
#include <string>
#include <string_view>

#include "measurement/measurement_builder.h"

namespace lrcs {

// The wavelength that a line in plain words names: "red laser (650 nm, 3.5mm spot)" -> 650e-9 [m].
// domain: the line mentions wavelength, lambda or laser, and one length in nm or um; else 0.
[[nodiscard]] double wavelength_in_words(std::string_view line);

// Looks through the comments of a file, lines that begin with #, for a wavelength in words. Where they name one, and no
// two different ones, the builder gets it, with a note.
void take_wavelength_of_comments(std::string_view content, MeasurementBuilder& builder);

}  // namespace lrcs
