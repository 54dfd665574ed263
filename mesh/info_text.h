#pragma once
#include <string>
#include <string_view>

#include "mesh/diagnosis.h"

namespace lrcs {

// What `lrcs info` prints for people: one fact a line, aligned, then the parts as a table.
// `file` heads it; `unit` is the file's unit by its name (base/length.h) and `d` in metres; unit "" : the unit is not
// known, `d` is in the file's unit, and that is said.
[[nodiscard]] std::string info_text(const Diagnosis& d, std::string_view file, std::string_view unit);

// The same as JSON, indented, with a line end: facets, vertices, area_m2, volume_m3, box_m, closed, unit, diagnosis,
// parts. What is not known is null: the unit and all that needs it, where unit is ""; the volume of an open part; a
// part's material where the file names none; colours.
[[nodiscard]] std::string info_json(const Diagnosis& d, std::string_view unit);

}  // namespace lrcs
