#pragma once
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

namespace lrcs {

// What a reader may take of the machine.
struct ReaderLimits {
  double processor_s = 60.0;         // [s]; ten times that by the clock
  std::size_t memory = 4ULL << 30U;  // [bytes] beyond what the program has already
};

// The program is not installed as it should be: not the file's fault.
class ReaderNotLoaded : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Runs `work` in a process of its own and gives the bytes that it returns: a library that a damaged file kills, or
// makes run for ever, does not take the program with it. What it prints is thrown away. error: an InputError of `work`
// comes out here; another exception, a signal or a limit is an InputError that names
//   the file. std::runtime_error where no process can be had, ReaderNotLoaded as `work` throws it.
// law: the process ends with this one.
// domain: call it before threads are started, or where they hold no lock that `work` needs; `work` has one thread.
[[nodiscard]] std::string contained(const std::string& file, const ReaderLimits& limits,
                                    const std::function<std::string()>& work);

}  // namespace lrcs
