#pragma once
#include <string>

#include "base/located_yaml.h"

namespace lrcs {

// Words that the mappings of several models share. Wrong values: InputError at file:line:column.

// Key azimuth_of_specular: 180 or 0 [deg]; `otherwise` where it is missing.
[[nodiscard]] int azimuth_of_specular_from_yaml(const LocatedYaml& node, int otherwise);

// Key wavelength [m]; 0 where it is missing.
[[nodiscard]] double wavelength_from_yaml(const LocatedYaml& node);

// The text between double quotes, as YAML writes it.
[[nodiscard]] std::string quoted_yaml(const std::string& text);

}  // namespace lrcs
