#pragma once
#include <cstddef>

namespace lrcs {

// value: bytes read and written a second by the best of several copies of a large array, one thread, as STREAM's
// Copy counts them (J. D. McCalpin, IEEE TCCA Newsletter, 1995).
[[nodiscard]] double copy_bandwidth(std::size_t bytes);

}  // namespace lrcs
