#pragma once
#include <chrono>

namespace lrcs {

// Wall time since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

// value: seconds that the call takes.
template <class Call>
[[nodiscard]] double seconds_of(const Call& call) {
  const Stopwatch watch;
  call();
  return watch.seconds();
}

}  // namespace lrcs
