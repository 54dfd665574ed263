#pragma once
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input_error.h"

namespace lrcs {

struct YamlDocument;
struct YamlValue;

// A YAML value that knows its place, so that every complaint is "file:line:column: ...". Read-only, cheap to copy.
// Every accessor throws InputError where the value is not what was asked for: another kind, NaN, outside its domain.
// domain: one document of UTF-8 text, at most 16 MiB, nested at most 100 deep, aliases counted where they are used.
//         A word in quotes is text, never a number. An alias has the place of what it stands for.
class LocatedYaml {
 public:
  // Duplicate keys anywhere, several documents, aliases that make a cycle, syntax errors, an empty file: InputError.
  static LocatedYaml of_file(const std::filesystem::path& file);
  // The same from text; `name` stands for the file in messages.
  static LocatedYaml of_text(const std::string& text, const std::string& name);

  [[nodiscard]] Place place() const;
  [[noreturn]] void fail(const std::string& message) const;

  // Mappings. A key outside `known` is an error that names the nearest known one.
  void allow_keys(std::initializer_list<std::string_view> known) const;
  void allow_keys(const std::vector<std::string>& known) const;
  [[nodiscard]] bool has(const std::string& key) const;
  [[nodiscard]] LocatedYaml at(const std::string& key) const;                      // error: "key 'x' is missing"
  [[nodiscard]] std::vector<std::pair<std::string, LocatedYaml>> entries() const;  // in file order
  [[nodiscard]] LocatedYaml key_place(const std::string& key) const;  // the key's own place, for complaints about it

  // Sequences, in order.
  [[nodiscard]] std::vector<LocatedYaml> items() const;

  // Scalars. number(): finite only.
  [[nodiscard]] bool is_scalar() const;
  [[nodiscard]] bool is_map() const;
  [[nodiscard]] bool is_sequence() const;
  [[nodiscard]] bool is_number() const;  // number() will give one
  [[nodiscard]] double number() const;
  [[nodiscard]] std::string text() const;
  // The scalar must be one of the words; an error names them all, the nearest first.
  [[nodiscard]] std::string one_of(std::initializer_list<std::string_view> words) const;
  [[nodiscard]] std::string one_of(const std::vector<std::string>& words) const;

 private:
  LocatedYaml(std::shared_ptr<const YamlDocument> document, std::size_t index);
  [[nodiscard]] const YamlValue& value() const;
  [[nodiscard]] const YamlValue& value_as_map() const;
  [[noreturn]] void expected(std::string_view what) const;
  std::shared_ptr<const YamlDocument> document_;
  std::size_t index_;
};

}  // namespace lrcs
