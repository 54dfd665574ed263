#include "brdf/tabulated_yaml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/digest.h"
#include "base/length.h"
#include "base/path_from.h"
#include "brdf/yaml_words.h"

namespace lrcs {
namespace {

constexpr std::array outside_rules{Outside::error, Outside::nearest, Outside::zero};

Outside outside_from_yaml(const LocatedYaml& node) {
  if (!node.has("outside")) return Outside::error;
  std::vector<std::string> words;
  words.reserve(outside_rules.size());
  for (const Outside rule : outside_rules) words.emplace_back(word_of(rule));
  const std::string said = node.at("outside").one_of(words);
  return *std::find_if(outside_rules.begin(), outside_rules.end(), [&](Outside rule) { return said == word_of(rule); });
}

MeasuredFile file_from_yaml(const LocatedYaml& node) {
  MeasuredFile file;
  const LocatedYaml name = node.at("file");
  const auto path = std::filesystem::path(name.place().file).parent_path() / name.text();
  std::error_code none;
  if (!std::filesystem::exists(path, none)) name.fail(fmt::format("no such file: {}", path.string()));
  file.path = path.string();
  if (node.has("azimuth_of_specular")) file.options.azimuth_of_specular = azimuth_of_specular_from_yaml(node, 180);
  if (node.has("wavelength")) file.wavelength_asked = wavelength_from_yaml(node);
  return file;
}

std::string wavelengths_of(const std::vector<BrdfMeasurement>& measurements) {
  std::vector<std::string> words;
  words.reserve(measurements.size());
  for (const BrdfMeasurement& m : measurements)
    words.push_back(m.wavelength > 0.0 ? text_of_length(m.wavelength, "um") : "none stated");
  return fmt::format("{}", fmt::join(words, ", "));
}

// The one of the wavelength asked for; the only one, where it states none.
BrdfMeasurement chosen(const std::vector<BrdfMeasurement>& measurements, const MeasuredFile& file,
                       const LocatedYaml& node) {
  const auto& asked = file.wavelength_asked;
  if (!asked) {
    if (measurements.size() == 1) return measurements.front();
    node.at("file").fail(fmt::format("{} holds several wavelengths, expected key 'wavelength' with one of {}",
                                     file.path, wavelengths_of(measurements)));
  }
  if (measurements.size() == 1 && measurements.front().wavelength == 0.0) return measurements.front();
  if (const BrdfMeasurement* found = measured_at(measurements, *asked)) return *found;
  node.at("wavelength")
      .fail(fmt::format("{} holds no measurement at {}; it holds {}", file.path, text_of_length(*asked, "um"),
                        wavelengths_of(measurements)));
}

}  // namespace

const std::vector<std::string>& tabulated_keys() {
  static const std::vector<std::string> keys{"model", "file", "outside", "wavelength", "source", "azimuth_of_specular"};
  return keys;
}

Material tabulated_from_yaml(const LocatedYaml& node, const std::string& name) {
  node.allow_keys(tabulated_keys());
  const Outside outside = outside_from_yaml(node);
  MeasuredFile file = file_from_yaml(node);
  BrdfMeasurement measurement = chosen(read_brdf_measurements(file.path, file.options), file, node);
  file.digest = digest_of_file(file.path);
  if (measurement.wavelength == 0.0) measurement.wavelength = file.wavelength_asked.value_or(0.0);
  return {name, Tabulated(measurement, outside, file), measurement.wavelength,
          node.has("source") ? node.at("source").text() : ""};
}

std::string tabulated_to_yaml(const Tabulated& tabulated, const std::filesystem::path& folder) {
  const MeasuredFile& file = tabulated.file();
  const std::string path = folder.empty() ? file.path : path_from(folder, file.path);
  std::string yaml = fmt::format("model: {}\nfile: {}\n", tabulated_model, quoted_yaml(path));
  if (file.options.azimuth_of_specular)
    yaml += fmt::format("azimuth_of_specular: {}\n", *file.options.azimuth_of_specular);
  return yaml + fmt::format("outside: {}\n", word_of(tabulated.outside()));
}

}  // namespace lrcs
