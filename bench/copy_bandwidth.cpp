#include "bench/copy_bandwidth.h"

#include <algorithm>
#include <vector>

#include "bench/stopwatch.h"

namespace lrcs {

double copy_bandwidth(std::size_t bytes) {
  constexpr int copies = 10;
  std::vector<double> from(bytes / sizeof(double), 1.0), to(from.size(), 0.0);
  double best = 0.0;
  for (int k = 0; k < copies; ++k) {
    from[from.size() / 2] = k;
    const double seconds = seconds_of([&] { std::copy(from.begin(), from.end(), to.begin()); });
    if (to[to.size() / 2] == k) best = std::max(best, 2.0 * static_cast<double>(bytes) / seconds);
  }
  return best;
}

}  // namespace lrcs
