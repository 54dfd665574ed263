#include "measurement/comment_wavelength.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <set>

#include "base/length.h"
#include "base/text_scanner.h"

namespace lrcs {
namespace {

constexpr std::size_t longest_line = 1000;  // std::regex goes as deep as a line is long

bool speaks_of_light(const std::string& line) {
  static const std::regex words("wavelength|lambda|laser", std::regex::icase);
  return std::regex_search(line, words);
}

std::set<double> lengths_in(const std::string& line) {
  static const std::regex length(
      "(^|[^0-9.eE+-])([0-9]{1,6}(\\.[0-9]{1,9})?) ?(nm|um|\xc2\xb5m|\xce\xbcm)(?![A-Za-z0-9])");
  std::set<double> lengths;
  for (auto at = std::sregex_iterator(line.begin(), line.end(), length); at != std::sregex_iterator(); ++at) {
    const double metres = std::stod((*at)[2]) > 0.0 ? length_from_text((*at)[2].str() + " " + (*at)[4].str()) : 0.0;
    if (metres > 0.0) lengths.insert(metres);
  }
  return lengths;
}

}  // namespace

double wavelength_in_words(std::string_view line) {
  const std::string text(line.substr(0, longest_line));
  if (!speaks_of_light(text)) return 0.0;
  const std::set<double> lengths = lengths_in(text);
  return lengths.size() == 1 ? *lengths.begin() : 0.0;
}

void take_wavelength_of_comments(std::string_view content, MeasurementBuilder& builder) {
  TextScanner scanner(content, "");
  std::optional<double> found;
  int line = 0;
  do {
    const std::string_view text = scanner.rest_of_line();
    const double metres = text.starts_with('#') ? wavelength_in_words(text) : 0.0;
    if (metres == 0.0) continue;
    if (found && *found != metres) return;
    if (!found) line = scanner.line();
    found = metres;
  } while (scanner.next_line());
  if (!found) return;
  builder.set_wavelength(*found);
  builder.note(fmt::format("wavelength {} from the words of line {}", text_of_length(*found, "um"), line));
}

}  // namespace lrcs
