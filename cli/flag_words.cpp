#include "cli/flag_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "base/input_error.h"
#include "brdf/library.h"
#include "brdf/material_yaml.h"
#include "lrcs/sweep_yaml.h"

namespace lrcs {
namespace {

double angle_from(const std::string& word, const std::string& flag, const AngleDomain& domain) {
  const double angle = number_from_words(word, flag);
  if (!domain.holds(angle)) throw InputError(fmt::format("{}: expected {}, found {}", flag, domain.what, word));
  return angle;
}

std::vector<double> range_from(const std::vector<std::string>& range, const std::string& words, const std::string& flag,
                               const AngleDomain& domain) {
  const double from = angle_from(range[0], flag, domain);
  const double to = angle_from(range[1], flag, domain);
  const double step = number_from_words(range[2], flag);
  if (step == 0.0) throw InputError(fmt::format("{}: expected a step other than 0 deg, found '{}'", flag, words));
  if (std::abs(to - from) / std::abs(step) > static_cast<double>(most_directions))
    throw InputError(fmt::format("{}: '{}' has more than {} directions", flag, words, most_directions));
  auto angles = angle_range(from, to, step);
  if (angles.empty())
    throw InputError(
        fmt::format("{}: the sweep is empty: from {} in steps of {} never comes to {}", flag, from, step, to));
  return angles;
}

bool looks_like_a_file(const std::string& words) {
  const std::filesystem::path path(words);
  return path.has_parent_path() || path.extension() == ".yaml" || path.extension() == ".yml";
}

}  // namespace

const AngleDomain azimuth_domain{is_azimuth, "an azimuth of -360..360 deg"};
const AngleDomain elevation_domain{is_elevation, "an elevation of -90..90 deg"};
const AngleDomain incidence_domain{[](double deg) { return deg >= 0.0 && deg < 90.0; },
                                   "an angle of incidence of 0 to below 90 deg"};

std::vector<std::string> split(std::string_view words, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = words.find(separator, begin);
    parts.emplace_back(words.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

double number_from_words(std::string_view words, const std::string& flag) {
  std::string_view digits = words;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  double value = 0.0;
  const auto [stop, wrong] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (wrong != std::errc{} || stop != digits.data() + digits.size() || !std::isfinite(value))
    throw InputError(fmt::format("{}: expected a number, found '{}'", flag, words));
  return value;
}

std::vector<double> angles_from_words(const std::string& words, const std::string& flag, const AngleDomain& domain) {
  const auto range = split(words, ':');
  if (range.size() == 3) return range_from(range, words, flag, domain);
  if (range.size() != 1 || words.empty())
    throw InputError(fmt::format("{}: expected A, A,B,C or FROM:TO:STEP in deg, found '{}'", flag, words));
  std::vector<double> angles;
  for (const auto& word : split(words, ',')) angles.push_back(angle_from(word, flag, domain));
  return angles;
}

AspectAngles angle_pair_from_words(const std::string& words, const std::string& flag) {
  const auto parts = split(words, ',');
  if (parts.size() != 2)
    throw InputError(fmt::format("{}: expected AZIMUTH,ELEVATION in deg, found '{}'", flag, words));
  return {angle_from(parts[0], flag, azimuth_domain), angle_from(parts[1], flag, elevation_domain)};
}

Material material_from_argument(const std::string& words) {
  std::error_code none;
  if (!words.starts_with("lambert:") && find_in_library(words) == nullptr && looks_like_a_file(words) &&
      !std::filesystem::exists(words, none))
    throw InputError(fmt::format("material: no such file: '{}'", words));
  return material_from_words(words);
}

void require_output_file(const std::string& file, const std::string& flag, const std::vector<std::string>& endings) {
  const std::filesystem::path path = file;
  if (std::find(endings.begin(), endings.end(), path.extension().string()) == endings.end())
    throw InputError(fmt::format("{}: expected a file that ends in {}, found '{}'", flag, endings.front(), file));
  require_folder_of(path, flag);
}

void require_folder_of(const std::filesystem::path& file, const std::string& flag) {
  const std::filesystem::path folder = file.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw InputError(fmt::format("{}: no such folder: '{}'", flag, folder.string()));
}

PictureSize size_from_words(const std::string& words, const std::string& flag, const PictureSize& least) {
  constexpr int most = 8000;
  const auto numbers = split(words, 'x');
  PictureSize size{0, 0};
  const auto is_read = [](const std::string& word, int& pixels) {
    const auto [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), pixels);
    return wrong == std::errc{} && end == word.data() + word.size();
  };
  if (numbers.size() != 2 || !is_read(numbers[0], size.width) || !is_read(numbers[1], size.height) ||
      size.width < least.width || size.height < least.height || size.width > most || size.height > most)
    throw InputError(fmt::format("{}: expected WIDTHxHEIGHT, {}x{} to {}x{} pixels, found '{}'", flag, least.width,
                                 least.height, most, most, words));
  return size;
}

}  // namespace lrcs
