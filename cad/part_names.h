#pragma once
#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

namespace lrcs {

// Of siblings of one name each gets a number; what has no name, another.
[[nodiscard]] inline std::vector<std::string> numbered(std::vector<std::string> names, const std::string& otherwise) {
  std::map<std::string, int> count, used;
  for (std::string& name : names) {
    if (name.empty()) name = otherwise;
    ++count[name];
  }
  for (std::string& name : names)
    if (count[name] > 1) name = fmt::format("{}:{}", name, ++used[name]);
  return names;
}

}  // namespace lrcs
