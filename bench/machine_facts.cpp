#include "bench/machine_facts.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace lrcs {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

}  // namespace

std::string machine_facts() {
  std::array<double, 1> load{};
  const bool is_known = getloadavg(load.data(), 1) == 1;
  return fmt::format("{}, {} threads, load {}, compiler {}\n", processor(), std::thread::hardware_concurrency(),
                     is_known ? fmt::format("{:.1f}", load[0]) : "unknown", __VERSION__);
}

}  // namespace lrcs
