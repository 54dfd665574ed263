#pragma once
#include <functional>

namespace lrcs {

// How far the process grows at its peak, in resident memory, while the call runs [byte]; NaN where Linux does not tell.
// Memory that was freed before goes back to the system first, so that what is used again counts.
[[nodiscard]] double peak_growth(const std::function<void()>& call);

}  // namespace lrcs
