#pragma once
#include <fcntl.h>
#include <pty.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/scratch_folder.h"

namespace lrcs {

using Words = std::vector<std::string>;

inline Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// How a run of the program ended.
struct Outcome {
  int status = -1;       // the exit status; -signal where a signal ended it
  std::string out, err;  // on a terminal: both in `out`
};

// What a run finds around it.
struct Surroundings {
  std::filesystem::path folder = {};                                  // the working folder
  std::vector<std::pair<std::string, std::string>> environment = {};  // set; "" : unset
  long largest_file = -1;                                             // [bytes] as with ulimit -f
  int kill_after_ms = 60000;                                          // SIGKILL then
  std::string out_file = {};                                          // stdout goes there, if named
};

// In the child: becomes lrcs, or ends with status 127.
[[noreturn]] inline void become_lrcs(const std::vector<std::string>& arguments, const Surroundings& around) {
  if (!around.folder.empty() && chdir(around.folder.c_str()) != 0) _exit(127);
  for (const auto& [name, value] : around.environment) {
    if (value.empty())
      unsetenv(name.c_str());
    else
      setenv(name.c_str(), value.c_str(), 1);
  }
  if (around.largest_file >= 0) {
    const rlimit limit{static_cast<rlim_t>(around.largest_file), static_cast<rlim_t>(around.largest_file)};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(127);
  }
  std::vector<char*> words{const_cast<char*>("lrcs")};
  for (const auto& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(LRCS_PROGRAM, words.data());
  _exit(127);
}

// Waits for the child, at most the given time, then kills it.
inline int status_of(pid_t child, int kill_after_ms) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kill_after_ms);
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() >= end) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

// Runs lrcs as a child process; stdout and stderr are files, stdin is empty.
inline Outcome run_lrcs(const std::vector<std::string>& arguments, const Surroundings& around = {}) {
  const ScratchFolder caught;
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    const int none = open("/dev/null", O_RDONLY);
    const std::string out_file = around.out_file.empty() ? (caught.path() / "out").string() : around.out_file;
    const int out = open(out_file.c_str(), O_WRONLY | O_CREAT, 0600);
    const int err = open((caught.path() / "err").c_str(), O_WRONLY | O_CREAT, 0600);
    if (dup2(none, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) _exit(127);
    become_lrcs(arguments, around);
  }
  Outcome outcome;
  outcome.status = status_of(child, around.kill_after_ms);
  outcome.out = caught.read("out");
  outcome.err = caught.read("err");
  return outcome;
}

// The same with a pseudo-terminal for stdin, stdout and stderr.
inline Outcome run_lrcs_on_terminal(const std::vector<std::string>& arguments, const Surroundings& around) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child < 0) throw std::runtime_error("no pseudo-terminal");
  if (child == 0) become_lrcs(arguments, around);
  Outcome outcome;
  std::array<char, 4096> bytes{};
  for (ssize_t n = 0; (n = read(terminal, bytes.data(), bytes.size())) > 0;)
    outcome.out.append(bytes.data(), static_cast<std::size_t>(n));
  outcome.status = status_of(child, around.kill_after_ms);
  close(terminal);
  return outcome;
}

}  // namespace lrcs
