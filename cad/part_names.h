#pragma once
#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lrcs {

// Of siblings of one name each gets a number that makes it different from all; what has no name, another.
[[nodiscard]] inline std::vector<std::string> numbered(std::vector<std::string> names, const std::string& otherwise) {
  std::map<std::string, int> count, used;
  for (std::string& name : names) {
    if (name.empty()) name = otherwise;
    ++count[name];
  }
  for (std::string& name : names) {
    if (count[name] == 1) continue;
    std::string next;
    do {
      next = fmt::format("{}:{}", name, ++used[name]);
    } while (count.contains(next));
    name = std::move(next);
  }
  return names;
}

}  // namespace lrcs
