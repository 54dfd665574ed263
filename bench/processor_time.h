#pragma once
#include <ctime>

namespace lrcs {

// Processor time of this process since it was made: of work on one thread, what else the machine does hardly counts.
class ProcessorTime {
 public:
  [[nodiscard]] double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace lrcs
