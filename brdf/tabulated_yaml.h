#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/located_yaml.h"
#include "brdf/material.h"

namespace lrcs {

inline constexpr const char* tabulated_model = "tabulated";
[[nodiscard]] const std::vector<std::string>& tabulated_keys();

// A material from a mapping {model: tabulated, file: retro.dat, ...}.
// keys: file (relative to the YAML file), wavelength (which of those in the file, to 1e-3; or which it is, where the
//   file does not say), azimuth_of_specular (180 or 0, where the file does not say), outside (error, the default,
//   nearest or zero), source.
// error: InputError at file:line:column.
[[nodiscard]] Material tabulated_from_yaml(const LocatedYaml& node, const std::string& name);

// The mapping, one key a line, without wavelength and source. folder: the path is relative to it; "": relative to the
// working folder, or absolute.
[[nodiscard]] std::string tabulated_to_yaml(const Tabulated& tabulated, const std::filesystem::path& folder);

}  // namespace lrcs
