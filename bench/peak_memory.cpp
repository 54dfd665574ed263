#include "bench/peak_memory.h"

#include <malloc.h>

#include <fstream>
#include <limits>
#include <string>

namespace lrcs {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// A line of /proc/self/status, "VmHWM:  1234 kB" [byte].
double status(const std::string& key) {
  std::ifstream file("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (file >> word)
    if (word == key && file >> kilobytes) return 1024.0 * kilobytes;
  return unknown;
}

// Sets the peak back to what is resident now.
bool forget_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  return file.good();
}

}  // namespace

double peak_growth(const std::function<void()>& call) {
  malloc_trim(0);
  const bool forgotten = forget_peak();
  const double before = status("VmRSS:");
  call();
  return forgotten ? status("VmHWM:") - before : unknown;
}

}  // namespace lrcs
