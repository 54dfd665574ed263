#include "measurement/csv_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/length.h"
#include "base/nearest_name.h"

namespace lrcs {
namespace {

constexpr std::size_t longest_name = 60;  // of which another may be a slip of the pen

constexpr std::array keys{"wavelength", "azimuth_of_specular", "value"};

constexpr std::string_view expected_header = "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr[,weight]";

struct KnownColumn {
  std::string_view name;
  std::string_view quantity;  // what a column of the same in another unit begins with
  Column column;
};

constexpr std::array known_columns{
    KnownColumn{"theta_i_deg", "theta_i", Column::theta_i}, KnownColumn{"theta_r_deg", "theta_r", Column::theta_r},
    KnownColumn{"phi_deg", "phi", Column::azimuth_r}, KnownColumn{"f_r_per_sr", "f_r", Column::value},
    KnownColumn{"weight", "weight", Column::weight}};

std::string trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t end = text.find_last_not_of(" \t") + 1;
  return std::string(text.substr(begin, std::max(begin, end) - begin));
}

double length(const TextScanner& scanner, const std::string& value) {
  try {
    return length_from_text(value);
  } catch (const std::invalid_argument& error) {
    scanner.fail(fmt::format("wavelength: {}", error.what()));
  }
}

int azimuth(const TextScanner& scanner, const std::string& value) {
  if (value != "180" && value != "0")
    scanner.fail(fmt::format("expected azimuth_of_specular: 180 or 0, found '{}'", shown(value)));
  return value == "0" ? 0 : 180;
}

bool has_cosine(const TextScanner& scanner, const std::string& value) {
  if (value != "brdf" && value != "brdf_cosine")
    scanner.fail(fmt::format("expected value: brdf or brdf_cosine, found '{}'{}", shown(value),
                             did_you_mean(value.substr(0, longest_name), {"brdf", "brdf_cosine"})));
  return value == "brdf_cosine";
}

// "value = brdf_cosine" is meant as a key, and would be taken for prose.
void refuse_equals_sign(const TextScanner& scanner, std::string_view comment) {
  const std::string key = trimmed(comment.substr(0, comment.find('=')));
  if (comment.find('=') != std::string_view::npos && std::find(keys.begin(), keys.end(), key) != keys.end())
    scanner.fail(fmt::format("expected '{}: ...', found '='", key));
}

void read_comment(const TextScanner& scanner, std::string_view comment, CsvComments& said) {
  const std::size_t colon = comment.find(':');
  if (colon == std::string_view::npos) return refuse_equals_sign(scanner, comment);
  const std::string key = trimmed(comment.substr(0, colon));
  const std::string value = trimmed(comment.substr(colon + 1));
  if (key == "wavelength") return take_said(said.wavelength, length(scanner, value), scanner, key);
  if (key == "azimuth_of_specular")
    return take_said(said.convention.azimuth_of_specular, azimuth(scanner, value), scanner, key);
  if (key == "value") return take_said(said.convention.value_has_cosine, has_cosine(scanner, value), scanner, key);
  if (key.size() > longest_name) return;
  const std::string meant = did_you_mean(key, {keys.begin(), keys.end()});
  if (!meant.empty()) scanner.fail(fmt::format("unknown key '{}'{}", shown(key), meant));
}

// The row of names. Each is taken with its place.
class HeaderRow {
 public:
  explicit HeaderRow(TextScanner& scanner) : end_(scanner) {
    while (const auto text = scanner.cell()) {
      if (names_.size() == most_columns)
        scanner.fail(fmt::format("expected at most {} columns, found more", most_columns));
      names_.push_back({lower_case(*text), scanner});
    }
    end_ = scanner;
    require_names();
  }

  [[nodiscard]] std::vector<Column> columns() const {
    std::vector<Column> columns(names_.size(), Column::ignored);
    for (const KnownColumn& known : known_columns) {
      const auto found = find(known.name, names_.begin());
      if (found == names_.end()) {
        refuse_lack_of(known);
        continue;
      }
      columns[static_cast<std::size_t>(found - names_.begin())] = known.column;
      const auto again = find(known.name, found + 1);
      if (again != names_.end()) again->scanner.fail(fmt::format("a second column '{}', expected one", known.name));
    }
    return columns;
  }

 private:
  struct Name {
    std::string text;
    TextScanner scanner;  // at its place
  };
  using Names = std::vector<Name>;

  [[nodiscard]] Names::const_iterator find(std::string_view name, Names::const_iterator from) const {
    return std::find_if(from, names_.end(), [&](const Name& n) { return n.text == name; });
  }

  void require_names() const {
    const Name& first = names_.front();
    if (begins_with_number(first.text))
      first.scanner.fail(fmt::format("{}no header row names the columns, expected {}, found '{}'",
                                     numbers_in_row() < 4 ? "too few numbers in a row to hold angles, and " : "",
                                     expected_header, shown(first.text)));
    if (names_.size() == 1)
      first.scanner.fail(
          fmt::format("expected columns between commas, {}, found '{}'", expected_header, shown(first.text)));
  }

  // Whatever separates them.
  [[nodiscard]] std::size_t numbers_in_row() const {
    std::size_t count = 0;
    for (const Name& name : names_) {
      TextScanner words(name.text, "");
      while (!words.word().empty()) ++count;
    }
    return count;
  }

  // A column that nearly has the name is an error even where the column may be left out.
  void refuse_lack_of(const KnownColumn& known) const {
    for (const Name& name : names_) {
      if (!is_meant(name.text, known)) continue;
      name.scanner.fail(fmt::format("expected a column '{}', found '{}'", known.name, shown(name.text)));
    }
    if (known.column == Column::weight) return;
    end_.fail(fmt::format("no column '{}', expected {}", known.name, expected_header));
  }

  static bool is_meant(const std::string& name, const KnownColumn& known) {
    std::vector<std::string> all;
    for (const KnownColumn& k : known_columns) {
      if (k.name == name) return false;
      all.emplace_back(k.name);
    }
    if (name.size() > longest_name) return false;
    return name.starts_with(known.quantity) || nearest_name(name, all) == known.name;
  }

  Names names_;
  TextScanner end_;
};

}  // namespace

CsvComments read_csv_comments(TextScanner scanner) {
  CsvComments said;
  do {
    TextScanner ahead = scanner;
    const std::string_view line = ahead.rest_of_line();
    if (line.starts_with('#')) read_comment(ahead, line.substr(1), said);
  } while (scanner.next_line());
  return said;
}

std::vector<Column> read_csv_columns(TextScanner& scanner) {
  return HeaderRow(scanner).columns();
}

bool begins_with_number(std::string_view text) {
  return !text.empty() && std::string_view("+-.0123456789").find(text.front()) != std::string_view::npos;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

}  // namespace lrcs
