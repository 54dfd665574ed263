#pragma once
#include <cmath>
#include <string_view>

#include "base/text_scanner.h"

namespace lrcs {

// What a coordinate may be: finite, and small enough that areas and volumes do not overflow.
[[nodiscard]] inline bool is_coordinate(double x) {
  return std::abs(x) <= 1e100;
}

// The next word of the line as a coordinate.
inline double coordinate(TextScanner& scanner) {
  const std::string_view found = scanner.word();
  const double x = scanner.number_in(found, "a coordinate, a finite number");
  if (!is_coordinate(x)) scanner.fail_expected("a coordinate of at most 1e100", found);
  return x;
}

}  // namespace lrcs
