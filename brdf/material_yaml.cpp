#include "brdf/material_yaml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "base/length.h"
#include "base/nearest_name.h"
#include "brdf/brdf_form.h"
#include "brdf/library.h"

namespace lrcs {
namespace {

std::vector<std::string> form_names() {
  std::vector<std::string> names;
  for (const BrdfForm& form : brdf_forms()) names.push_back(form.name);
  return names;
}

std::vector<std::string> keys_of(const BrdfForm& form) {
  std::vector<std::string> keys{"model"};
  keys.insert(keys.end(), form.parameters.begin(), form.parameters.end());
  keys.insert(keys.end(), {"wavelength", "source"});
  if (form.has_azimuth_of_specular) keys.emplace_back("azimuth_of_specular");
  return keys;
}

// A key of another form is a mistake about the form, not about the key.
void refuse_keys_of_other_forms(const LocatedYaml& node, const BrdfForm& form) {
  const auto own = keys_of(form);
  for (const auto& [key, value] : node.entries()) {
    if (std::find(own.begin(), own.end(), key) != own.end()) continue;
    for (const BrdfForm& other : brdf_forms()) {
      const auto theirs = keys_of(other);
      if (std::find(theirs.begin(), theirs.end(), key) != theirs.end())
        node.key_place(key).fail(fmt::format("unknown key '{}' of {}: it belongs to {} (known: {})", key, form.name,
                                             other.name, fmt::join(own, ", ")));
    }
  }
}

int azimuth_of_specular(const LocatedYaml& node, int otherwise) {
  if (!node.has("azimuth_of_specular")) return otherwise;
  const LocatedYaml azimuth = node.at("azimuth_of_specular");
  if (!azimuth.is_number() || (azimuth.number() != 180.0 && azimuth.number() != 0.0))
    azimuth.fail("expected azimuth_of_specular 180 or 0" +
                 (azimuth.is_scalar() ? fmt::format(", found '{}'", azimuth.text()) : std::string()));
  return static_cast<int>(azimuth.number());
}

double wavelength(const LocatedYaml& node) {
  if (!node.has("wavelength")) return 0.0;
  const LocatedYaml value = node.at("wavelength");
  try {
    return length_from_text(value.text());
  } catch (const std::invalid_argument& error) {
    value.fail(error.what());
  }
}

Material from_library(const LocatedYaml& node, const std::string& name) {
  node.allow_keys({"library", "azimuth_of_specular"});
  const LocatedYaml wanted = node.at("library");
  const Material* found = find_in_library(wanted.text());
  if (found == nullptr)
    wanted.fail(fmt::format("unknown library material '{}'{} (known: {})", wanted.text(),
                            did_you_mean(wanted.text(), library_names()), fmt::join(library_names(), ", ")));
  Material material = *found;
  const BrdfWords words = words_of(found->brdf);
  material.brdf = words.form->make(words.values, azimuth_of_specular(node, words.azimuth_of_specular));
  material.name = name;
  material.source = fmt::format("{}: {}", found->name, found->source);
  return material;
}

Brdf brdf_from_yaml(const LocatedYaml& node, const BrdfForm& form) {
  std::vector<double> values;
  for (const std::string& key : form.parameters) values.push_back(node.at(key).number());
  try {
    return form.make(values, form.has_azimuth_of_specular ? azimuth_of_specular(node, 180) : 180);
  } catch (const ParameterError& error) {
    node.at(error.parameter()).fail(error.what());
  }
}

std::string quoted(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

Material from_reflectance(const std::string& words, std::string_view digits) {
  double reflectance = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), reflectance);
  if (error != std::errc{} || end != digits.data() + digits.size())
    throw InputError(fmt::format("material '{}': expected a reflectance in [0, 1] after 'lambert:'", words));
  try {
    return {words, Lambert(reflectance), 0.0, ""};
  } catch (const ParameterError& out_of_domain) {
    throw InputError(fmt::format("material '{}': {}", words, out_of_domain.what()));
  }
}

}  // namespace

Material material_from_yaml(const LocatedYaml& node, const std::string& name) {
  if (node.has("library")) return from_library(node, name);
  if (!node.has("model")) node.fail("key 'model' or 'library' is missing");
  const BrdfForm& form = *find_brdf_form(node.at("model").one_of(form_names()));
  refuse_keys_of_other_forms(node, form);
  node.allow_keys(keys_of(form));
  return {name, brdf_from_yaml(node, form), wavelength(node), node.has("source") ? node.at("source").text() : ""};
}

std::string material_to_yaml(const Material& material) {
  const BrdfWords words = words_of(material.brdf);
  std::string yaml = fmt::format("model: {}\n", words.form->name);
  for (std::size_t k = 0; k < words.values.size(); ++k)
    yaml += fmt::format("{}: {}\n", words.form->parameters[k], words.values[k]);
  if (words.form->has_azimuth_of_specular) yaml += fmt::format("azimuth_of_specular: {}\n", words.azimuth_of_specular);
  if (material.wavelength > 0.0) yaml += fmt::format("wavelength: {}\n", text_of_length(material.wavelength, "um"));
  if (!material.source.empty()) yaml += fmt::format("source: {}\n", quoted(material.source));
  return yaml;
}

Material material_from_words(const std::string& words) {
  constexpr std::string_view lambert = "lambert:";
  if (words.starts_with(lambert)) return from_reflectance(words, std::string_view(words).substr(lambert.size()));
  if (const Material* found = find_in_library(words)) return *found;
  if (std::filesystem::exists(words))
    return material_from_yaml(LocatedYaml::of_file(words), std::filesystem::path(words).stem().string());
  throw InputError(fmt::format("unknown material '{}'{} (expected lambert:REFLECTANCE, a YAML file, or one of {})",
                               words, did_you_mean(words, library_names()), fmt::join(library_names(), ", ")));
}

}  // namespace lrcs
