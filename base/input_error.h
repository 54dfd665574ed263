#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace lrcs {

// A place in the user's input. Lines and columns count from 1; 0: not known.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;

  [[nodiscard]] std::string text() const {
    if (line <= 0) return file;
    return column > 0 ? fmt::format("{}:{}:{}", file, line, column) : fmt::format("{}:{}", file, line);
  }
};

// The user's input is wrong. what(): one line, "file:line:column: what is wrong, what was expected". The program
// exits 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(const Place& place, const std::string& message) : std::runtime_error(place.text() + ": " + message) {}
};

}  // namespace lrcs
