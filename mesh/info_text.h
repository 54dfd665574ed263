#pragma once
#include <string>
#include <vector>

#include "mesh/diagnosis.h"

namespace lrcs {

// A part's name as people see it; "" is one that the file gives no name.
[[nodiscard]] std::string shown_name(const std::string& name);

// What is known of a file besides its facets.
struct FileFacts {
  std::string file;
  std::string unit;  // its name (base/length.h), the diagnosis being in metres; "": not known, it is in the file's
  std::string tessellation;  // how facets were made of surfaces; "" where the file holds facets
  std::vector<std::string> warnings;
};

// What `lrcs info` prints for people: one fact a line, aligned, then the parts as a tree with the sums of what holds
// them, and a block `assign:` for a scene file, by what tells the parts apart: colours, materials, or parts.
[[nodiscard]] std::string info_text(const Diagnosis& d, const FileFacts& facts);

// The same as JSON, indented, with a line end: facets, vertices, area_m2, volume_m3, box_m, closed, unit, diagnosis,
// parts; tessellation, warnings, a part's layer and what is wrong with it where there are any. What is not known is
// null: the unit and all that needs it, where unit is ""; the volume of an open part; a part's material and colour
// where the file names none.
[[nodiscard]] std::string info_json(const Diagnosis& d, const FileFacts& facts);

}  // namespace lrcs
