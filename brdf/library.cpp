#include "brdf/library.h"

#include <algorithm>

namespace lrcs {
namespace {

Material published(const std::string& name, const WuParameters<double>& parameters) {
  return {name, Wu(parameters), 1.06e-6, "Wang and Wu, Infrared and Laser Engineering 43(1), 332-337, 2014"};
}

}  // namespace

const std::vector<Material>& material_library() {
  static const std::vector<Material> library{
      published("metal-skin-5p", {.kb = 0.117, .kr = 0.321, .b = -24.589, .a = 0.905, .kd = 0.051}),
      published("metal-skin-9p", {.kb = 0.117,
                                  .kr = 1.901,
                                  .b = -17.733,
                                  .a = 0.915,
                                  .kd = 0.045,
                                  .sigma_p = 0.9369,
                                  .sigma_r = 0.0036,
                                  .u_p = 17.0645,
                                  .v_p = 5.5292}),
      published("painted-steel-5p", {.kb = 0.153, .kr = 0.456, .b = -26.998, .a = 0.667, .kd = 0.015}),
      published("painted-steel-9p", {.kb = 0.168,
                                     .kr = 1.784,
                                     .b = -27.825,
                                     .a = 0.663,
                                     .kd = 0.0165,
                                     .sigma_p = 0.6669,
                                     .sigma_r = 0.5695,
                                     .u_p = 18.1386,
                                     .v_p = 3.5056})};
  return library;
}

const Material* find_in_library(std::string_view name) {
  const auto& library = material_library();
  const auto found = std::find_if(library.begin(), library.end(), [&](const Material& m) { return m.name == name; });
  return found == library.end() ? nullptr : &*found;
}

std::vector<std::string> library_names() {
  std::vector<std::string> names;
  for (const Material& material : material_library()) names.push_back(material.name);
  return names;
}

}  // namespace lrcs
