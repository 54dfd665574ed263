#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/input_error.h"

namespace lrcs {

// One value of a YAML document: what LocatedYaml looks at. Children are indices into YamlDocument::values.
struct YamlValue {
  enum class Kind { null, scalar, sequence, mapping };
  Kind kind = Kind::null;
  Place place;
  std::string text;                // of a scalar
  bool quoted = false;             // a scalar in quotes, or with an explicit tag
  std::size_t depth = 1;           // levels from here down to the deepest scalar
  std::vector<std::size_t> items;  // of a sequence
  std::vector<std::pair<std::size_t, std::size_t>>
      entries;  // of a mapping: key, value; in file order, keys all different
};

// All values in file order; the root comes first.
struct YamlDocument {
  std::vector<YamlValue> values;
};

// The single document of a text. Throws InputError as LocatedYaml says; `file` stands for the text in messages.
[[nodiscard]] YamlDocument yaml_document(const std::string& text, const std::string& file);

}  // namespace lrcs
