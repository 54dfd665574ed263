#include "brdf/material_yaml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "base/length.h"
#include "base/nearest_name.h"
#include "brdf/brdf_form.h"
#include "brdf/library.h"
#include "brdf/tabulated_yaml.h"
#include "brdf/yaml_words.h"

namespace lrcs {
namespace {

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const BrdfForm& form : brdf_forms()) names.push_back(form.name);
  names.emplace_back(tabulated_model);
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
    const auto refuse_key_among = [&, &word = key](const std::vector<std::string>& theirs, std::string_view other) {
      if (std::find(theirs.begin(), theirs.end(), word) != theirs.end())
        node.key_place(word).fail(fmt::format("unknown key '{}' of {}: it belongs to {} (known: {})", word, form.name,
                                              other, fmt::join(own, ", ")));
    };
    if (std::find(own.begin(), own.end(), key) != own.end()) continue;
    for (const BrdfForm& other : brdf_forms()) refuse_key_among(keys_of(other), other.name);
    refuse_key_among(tabulated_keys(), tabulated_model);
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
  material.brdf = words.form->make(words.values, azimuth_of_specular_from_yaml(node, words.azimuth_of_specular));
  material.name = name;
  material.source = fmt::format("{}: {}", found->name, found->source);
  return material;
}

Brdf brdf_from_yaml(const LocatedYaml& node, const BrdfForm& form) {
  std::vector<double> values;
  for (const std::string& key : form.parameters) values.push_back(node.at(key).number());
  try {
    return form.make(values, form.has_azimuth_of_specular ? azimuth_of_specular_from_yaml(node, 180) : 180);
  } catch (const ParameterError& error) {
    node.at(error.parameter()).fail(error.what());
  }
}

std::string brdf_to_yaml(const Brdf& brdf, const std::filesystem::path& folder) {
  if (const auto* tabulated = std::get_if<Tabulated>(&brdf)) return tabulated_to_yaml(*tabulated, folder);
  const BrdfWords words = words_of(brdf);
  std::string yaml = fmt::format("model: {}\n", words.form->name);
  for (std::size_t k = 0; k < words.values.size(); ++k)
    yaml += fmt::format("{}: {}\n", words.form->parameters[k], words.values[k]);
  if (words.form->has_azimuth_of_specular) yaml += fmt::format("azimuth_of_specular: {}\n", words.azimuth_of_specular);
  return yaml;
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
  const std::string model = node.at("model").one_of(model_names());
  if (model == tabulated_model) return tabulated_from_yaml(node, name);
  const BrdfForm& form = *find_brdf_form(model);
  refuse_keys_of_other_forms(node, form);
  node.allow_keys(keys_of(form));
  return {name, brdf_from_yaml(node, form), wavelength_from_yaml(node),
          node.has("source") ? node.at("source").text() : ""};
}

std::string material_to_yaml(const Material& material, const std::filesystem::path& folder) {
  std::string yaml = brdf_to_yaml(material.brdf, folder);
  if (material.wavelength > 0.0) yaml += fmt::format("wavelength: {}\n", text_of_length(material.wavelength, "um"));
  if (!material.source.empty()) yaml += fmt::format("source: {}\n", quoted_yaml(material.source));
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
