#include "brdf/yaml_words.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <stdexcept>

#include "base/length.h"

namespace lrcs {

int azimuth_of_specular_from_yaml(const LocatedYaml& node, int otherwise) {
  if (!node.has("azimuth_of_specular")) return otherwise;
  const LocatedYaml azimuth = node.at("azimuth_of_specular");
  if (!azimuth.is_number() || (azimuth.number() != 180.0 && azimuth.number() != 0.0))
    azimuth.fail("expected azimuth_of_specular 180 or 0" +
                 (azimuth.is_scalar() ? fmt::format(", found '{}'", azimuth.text()) : std::string()));
  return static_cast<int>(azimuth.number());
}

double wavelength_from_yaml(const LocatedYaml& node) {
  if (!node.has("wavelength")) return 0.0;
  const LocatedYaml value = node.at("wavelength");
  try {
    return length_from_text(value.text());
  } catch (const std::invalid_argument& error) {
    value.fail(error.what());
  }
}

std::string quoted_yaml(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

}  // namespace lrcs
