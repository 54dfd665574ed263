#include "base/located_yaml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/digest.h"
#include "base/nearest_name.h"
#include "base/text_scanner.h"
#include "base/yaml_document.h"

namespace lrcs {
namespace {

using Kind = YamlValue::Kind;

std::vector<std::string> strings(std::initializer_list<std::string_view> words) {
  return {words.begin(), words.end()};
}

std::string description(const YamlValue& value) {
  switch (value.kind) {
    case Kind::null:
      return "nothing";
    case Kind::sequence:
      return "a list";
    case Kind::mapping:
      return "a mapping";
    case Kind::scalar:
      break;
  }
  constexpr std::size_t longest = 60;
  const std::string text = value.text.size() > longest ? shown(value.text) : value.text;
  return value.quoted ? fmt::format("the text '{}'", text) : fmt::format("'{}'", text);
}

// A plain scalar as a double, which may be infinite or NaN; nothing where it is no number.
std::optional<double> number_in(const YamlValue& value) {
  if (value.kind != Kind::scalar || value.quoted) return std::nullopt;
  std::string_view digits = value.text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const bool negative = digits.starts_with('-');
  if (negative && value.text.starts_with('+')) return std::nullopt;
  const std::string_view magnitude = digits.substr(negative ? 1 : 0);
  for (const std::string_view word : {".nan", ".NaN", ".NAN", ".inf", ".Inf", ".INF"})
    if (magnitude == word) return std::nan("");
  if (magnitude.find_first_not_of("0123456789.eE+-") != std::string_view::npos) return std::nullopt;
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? std::nan("") : number;
}

std::optional<std::pair<std::size_t, std::size_t>> entry_of(const YamlDocument& document, const YamlValue& map,
                                                            std::string_view key) {
  for (const auto& entry : map.entries)
    if (document.values[entry.first].text == key) return entry;
  return std::nullopt;
}

}  // namespace

LocatedYaml::LocatedYaml(std::shared_ptr<const YamlDocument> document, std::size_t index)
    : document_(std::move(document)), index_(index) {}

LocatedYaml LocatedYaml::of_file(const std::filesystem::path& file) {
  return of_text(content_of_file(file), file.string());
}

LocatedYaml LocatedYaml::of_text(const std::string& text, const std::string& name) {
  return {std::make_shared<const YamlDocument>(yaml_document(text, name)), 0};
}

const YamlValue& LocatedYaml::value() const {
  return document_->values[index_];
}

Place LocatedYaml::place() const {
  return value().place;
}

void LocatedYaml::fail(const std::string& message) const {
  throw InputError(place(), message);
}

void LocatedYaml::expected(std::string_view what) const {
  fail(fmt::format("expected {}, found {}", what, description(value())));
}

const YamlValue& LocatedYaml::value_as_map() const {
  if (!is_map()) expected("a mapping");
  return value();
}

void LocatedYaml::allow_keys(std::initializer_list<std::string_view> known) const {
  allow_keys(strings(known));
}

void LocatedYaml::allow_keys(const std::vector<std::string>& known) const {
  for (const auto& [key, unused] : value_as_map().entries) {
    const YamlValue& word = document_->values[key];
    if (std::find(known.begin(), known.end(), word.text) == known.end())
      throw InputError(word.place, fmt::format("unknown key '{}'{} (known: {})", word.text,
                                               did_you_mean(word.text, known), fmt::join(known, ", ")));
  }
}

bool LocatedYaml::has(const std::string& key) const {
  return entry_of(*document_, value_as_map(), key).has_value();
}

LocatedYaml LocatedYaml::at(const std::string& key) const {
  const auto entry = entry_of(*document_, value_as_map(), key);
  if (!entry) fail(fmt::format("key '{}' is missing", key));
  return {document_, entry->second};
}

LocatedYaml LocatedYaml::key_place(const std::string& key) const {
  const auto entry = entry_of(*document_, value_as_map(), key);
  if (!entry) fail(fmt::format("key '{}' is missing", key));
  return {document_, entry->first};
}

std::vector<std::pair<std::string, LocatedYaml>> LocatedYaml::entries() const {
  std::vector<std::pair<std::string, LocatedYaml>> all;
  for (const auto& [key, entry] : value_as_map().entries)
    all.emplace_back(document_->values[key].text, LocatedYaml(document_, entry));
  return all;
}

std::vector<LocatedYaml> LocatedYaml::items() const {
  if (!is_sequence()) expected("a list");
  std::vector<LocatedYaml> all;
  for (const std::size_t item : value().items) all.push_back(LocatedYaml(document_, item));
  return all;
}

bool LocatedYaml::is_scalar() const {
  return value().kind == Kind::scalar;
}
bool LocatedYaml::is_map() const {
  return value().kind == Kind::mapping;
}
bool LocatedYaml::is_sequence() const {
  return value().kind == Kind::sequence;
}

bool LocatedYaml::is_number() const {
  const auto number = number_in(value());
  return number && std::isfinite(*number);
}

double LocatedYaml::number() const {
  const auto number = number_in(value());
  if (!number) expected("a number");
  if (!std::isfinite(*number)) expected("a finite number");
  return *number;
}

std::string LocatedYaml::text() const {
  if (!is_scalar()) expected("text");
  return value().text;
}

std::string LocatedYaml::one_of(std::initializer_list<std::string_view> words) const {
  return one_of(strings(words));
}

std::string LocatedYaml::one_of(const std::vector<std::string>& words) const {
  if (is_scalar() && std::find(words.begin(), words.end(), value().text) != words.end()) return value().text;
  std::vector<std::string> nearest_first = words;
  const std::string nearest = is_scalar() ? nearest_name(value().text, words) : "";
  std::stable_partition(nearest_first.begin(), nearest_first.end(), [&](const auto& word) { return word == nearest; });
  expected(fmt::format("{}", fmt::join(nearest_first, " or ")));
}

}  // namespace lrcs
