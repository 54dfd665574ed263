#pragma once
#include <filesystem>
#include <string>

#include "base/located_yaml.h"
#include "brdf/material.h"

namespace lrcs {

// A material from a mapping of a scene's `materials:`, or of the file that `lrcs fit` writes.
//   {library: metal-skin-5p}              keys: library, azimuth_of_specular (in place of the library's)
//   {model: lambert, reflectance: 0.8}    keys: model, the form's parameters (brdf/brdf_form.h), wavelength, source,
//   {model: five_parameter, kb: 0.1, ...}   and azimuth_of_specular (180, the default, or 0) where the form has it
//   {model: tabulated, file: retro.dat}   a measurement: brdf/tabulated_yaml.h
// Wrong or missing keys and values outside their domain: InputError at file:line:column.
[[nodiscard]] Material material_from_yaml(const LocatedYaml& node, const std::string& name);

// The material as such a mapping, one key a line, without its name.
// law: material_from_yaml reads back the same BRDF, wavelength and source, to the last bit; that of a measurement as
//   long as its file is there.
// folder: where the mapping will lie, for the path of a measurement; "": in the working folder.
[[nodiscard]] std::string material_to_yaml(const Material& material, const std::filesystem::path& folder = {});

// A material from the command line: "lambert:0.8", a name of the library, or a YAML file that holds one mapping as
// above. The name of the library wins over a file called so. None of these: InputError.
[[nodiscard]] Material material_from_words(const std::string& words);

}  // namespace lrcs
