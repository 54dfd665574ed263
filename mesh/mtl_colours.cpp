#include "mesh/mtl_colours.h"

#include <fmt/format.h>

#include <cmath>

#include "base/input_error.h"
#include "base/text_scanner.h"
#include "mesh/file_content.h"

namespace lrcs {
namespace {

using Colours = std::map<std::string, std::string, std::less<>>;

std::string part_of_colour(const TextScanner& scanner, std::string_view word) {
  const double part = scanner.number_in(word, "a part of a colour, 0 to 1");
  if (!(part >= 0.0 && part <= 1.0)) scanner.fail_expected("a part of a colour, 0 to 1", word);
  return fmt::format("{:02x}", std::lround(255.0 * part));
}

// Behind Kd: red, green, blue; one number is a grey. "" for a spectrum.
std::string read_colour(TextScanner& scanner) {
  std::string_view word = scanner.word();
  if (word == "spectral" || word == "xyz") return "";
  const std::string red = part_of_colour(scanner, word);
  word = scanner.word();
  if (word.empty()) return "#" + red + red + red;
  const std::string green = part_of_colour(scanner, word);
  return "#" + red + green + part_of_colour(scanner, scanner.word());
}

Colours read_mtl(std::string_view content, const std::string& file) {
  TextScanner scanner(content, file);
  Colours colours;
  std::string* colour = nullptr;  // of the material that is described
  do {
    const std::string_view keyword = scanner.word();
    if (keyword == "newmtl") colour = &colours[std::string(scanner.rest_of_line())];
    if (keyword != "Kd") continue;
    if (colour == nullptr) scanner.fail("expected newmtl before Kd");
    *colour = read_colour(scanner);
  } while (scanner.next_line());
  return colours;
}

}  // namespace

void MtlColours::add_libraries(std::string_view names) {
  std::error_code none;
  if (std::filesystem::exists(folder_ / names, none)) return add(std::string(names));
  TextScanner scanner(names, "");
  for (std::string_view name = scanner.word(); !name.empty(); name = scanner.word()) add(std::string(name));
}

void MtlColours::add(const std::string& name) {
  if (!known_.insert(name).second) return;
  const std::filesystem::path file = folder_ / name;
  try {
    colours_.merge(read_mtl(plain_content(file), file.string()));
  } catch (const InputError& wrong) {
    if (warnings_ != nullptr) warnings_->push_back(fmt::format("{}; its materials have no colours", wrong.what()));
  }
}

std::string_view MtlColours::of(std::string_view material) const {
  const auto found = colours_.find(material);
  return found == colours_.end() ? std::string_view() : found->second;
}

}  // namespace lrcs
