#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"

namespace lrcs {

// The published materials, at 1.06 um: metal-skin-5p, metal-skin-9p, painted-steel-5p, painted-steel-9p.
// source: Wang and Wu, Infrared and Laser Engineering 43(1), 332-337, 2014.
[[nodiscard]] const std::vector<Material>& material_library();

// The material of that name, or nullptr.
[[nodiscard]] const Material* find_in_library(std::string_view name);

[[nodiscard]] std::vector<std::string> library_names();

}  // namespace lrcs
