#pragma once
#include <vector>

namespace lrcs {

// domain: not empty.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace lrcs
