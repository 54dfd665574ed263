#include "cad/contained.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string_view>

#include "base/input_error.h"

namespace lrcs {
namespace {

enum Outcome : char { bytes_follow = 'b', wrong_input = 'i', failed = 'f', out_of_memory = 'm', not_ready = 'n' };

// A file without a name that both processes have open.
class SharedFile {
 public:
  SharedFile() : descriptor_(memfd_create("lrcs-reader", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::runtime_error(fmt::format("no shared memory: {}", std::strerror(errno)));
  }
  ~SharedFile() { close(descriptor_); }
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;

  [[nodiscard]] bool write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }

  [[nodiscard]] std::string content() const {
    std::string bytes(static_cast<std::size_t>(lseek(descriptor_, 0, SEEK_END)), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count = pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) throw std::runtime_error("what a reader left cannot be read");
      done += static_cast<std::size_t>(count);
    }
    return bytes;
  }

 private:
  int descriptor_;
};

void limit(int resource, rlim_t most) {
  rlimit now{};
  getrlimit(static_cast<__rlimit_resource>(resource), &now);
  if (now.rlim_max != RLIM_INFINITY && now.rlim_max < most) most = now.rlim_max;
  now.rlim_cur = most;
  setrlimit(static_cast<__rlimit_resource>(resource), &now);
}

// Address space in use [bytes].
[[maybe_unused]] std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

constexpr double waiting = 10.0;  // longest time over processor time

void confine(const ReaderLimits& limits) {
  // A reader that only waits takes no processor time.
  alarm(static_cast<unsigned>(std::ceil(waiting * limits.processor_s)));
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.processor_s)));
#if !defined(__SANITIZE_ADDRESS__)  // its shadow takes terabytes of address space
  limit(RLIMIT_AS, address_space() + limits.memory);
#endif
  limit(RLIMIT_CORE, 0);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGALRM}) std::signal(signal, SIG_DFL);
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
#if !defined(__SANITIZE_ADDRESS__)  // it has things to say there
  dup2(nowhere, STDERR_FILENO);
#endif
}

[[noreturn]] void run_in_child(const SharedFile& result, const ReaderLimits& limits, pid_t parent,
                               const std::function<std::string()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  confine(limits);
  const auto finish = [&](Outcome outcome, std::string_view bytes) {
    const char first = outcome;
    _exit(result.write({&first, 1}) && result.write(bytes) ? 0 : 1);
  };
  // Threads of the parent are not here, and each new one would take of the memory that the file may.
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  try {
    finish(bytes_follow, work());
  } catch (const InputError& wrong) {
    finish(wrong_input, wrong.what());
  } catch (const ReaderNotLoaded& missing) {
    finish(not_ready, missing.what());
  } catch (const std::bad_alloc&) {
    finish(out_of_memory, "");
  } catch (const std::exception& other) {
    finish(failed, other.what());
  } catch (...) {
    finish(failed, "an unknown error");
  }
  _exit(1);
}

[[noreturn]] void complain_of_death(const std::string& file, const ReaderLimits& limits, int status) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGALRM)
    throw InputError(Place{file}, fmt::format("its reader was not done after {:.0f} s: does it wait for something?",
                                              std::ceil(waiting * limits.processor_s)));
  if (signal == SIGXCPU)
    throw InputError(Place{file}, fmt::format("its reader was not done after {:.0f} s of processor time: damaged?",
                                              std::ceil(limits.processor_s)));
  throw InputError(Place{file}, fmt::format("its reader broke down{}: damaged?",
                                            signal > 0 ? fmt::format(" ({})", strsignal(signal)) : ""));
}

}  // namespace

std::string contained(const std::string& file, const ReaderLimits& limits, const std::function<std::string()>& work) {
  const SharedFile result;
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(fmt::format("no process for a reader: {}", std::strerror(errno)));
  if (child == 0) run_in_child(result, limits, parent, work);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  std::string bytes = result.content();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) complain_of_death(file, limits, status);
  const char outcome = bytes.front();
  bytes.erase(0, 1);
  if (outcome == bytes_follow) return bytes;
  if (outcome == wrong_input) throw InputError(bytes);
  if (outcome == not_ready) throw ReaderNotLoaded(bytes);
  if (outcome == out_of_memory)
    throw InputError(Place{file},
                     fmt::format("its reader wanted more than {} MB of memory: damaged?", limits.memory >> 20U));
  throw InputError(Place{file}, fmt::format("cannot be read: {}", bytes));
}

}  // namespace lrcs
