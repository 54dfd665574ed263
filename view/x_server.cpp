#include "view/x_server.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <thread>

namespace lrcs {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds longest_start{10};
constexpr std::chrono::seconds longest_stop{2};
constexpr int display_channel = 3;  // the descriptor on which Xvfb tells its display number

std::string program_in_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path program = std::filesystem::path(folder.empty() ? "." : folder) / name;
    if (access(program.c_str(), X_OK) == 0) return program.string();
  }
  return "";
}

// Between fork and exec: only calls that are safe there, for other threads may have held any lock.
[[noreturn]] void become_server(const char* program, const char* screen, int channel, pid_t parent) {
  // Left out: -ac. Only this user may connect.
  const std::array<const char*, 9> arguments{"Xvfb", "-displayfd", "3",   "-screen", "0",
                                             screen, "-nolisten",  "tcp", nullptr};
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int null = open("/dev/null", O_RDWR);
  const int kept = fcntl(channel, F_DUPFD, 10);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(null, standard);
  dup2(kept, display_channel);
  // The caller's open files (a result half written, a pipe) are none of the server's business.
  close_range(display_channel + 1, ~0U, 0);
  // The parent may have died before prctl: then nobody would end us.
  if (getppid() != parent) _exit(EXIT_FAILURE);
  execv(program, const_cast<char* const*>(arguments.data()));
  _exit(EXIT_FAILURE);
}

int milliseconds_until(Clock::time_point end) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
  return left > 0 ? static_cast<int>(left) : 0;
}

// The line that the server writes when it is ready; "" if it ended, or takes too long.
std::string line_from(int channel) {
  const Clock::time_point end = Clock::now() + longest_start;
  std::string line;
  while (true) {
    pollfd waiting{channel, POLLIN, 0};
    const int ready = poll(&waiting, 1, milliseconds_until(end));
    if (ready < 0 && errno == EINTR) continue;
    char letter = 0;
    if (ready <= 0 || read(channel, &letter, 1) != 1) return "";
    if (letter == '\n') return line;
    line += letter;
  }
}

}  // namespace

std::unique_ptr<XServer> XServer::start(std::string* why_not, const std::string& screen) {
  const std::string program = program_in_path("Xvfb");
  if (program.empty()) {
    *why_not = "Xvfb is not installed (Debian package xvfb)";
    return nullptr;
  }
  std::array<int, 2> channel{};
  if (pipe2(channel.data(), O_CLOEXEC) != 0) {
    *why_not = std::string("Xvfb cannot be started: ") + std::strerror(errno);
    return nullptr;
  }
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) become_server(program.c_str(), screen.c_str(), channel[1], parent);
  close(channel[1]);
  std::unique_ptr<XServer> server;
  if (child > 0) {
    server.reset(new XServer(child));
    const std::string number = line_from(channel[0]);
    if (!number.empty()) server->display_ = ":" + number;
  }
  close(channel[0]);
  if (server == nullptr || server->display_.empty()) {
    *why_not = program + " does not start (may it write to /tmp, is xkb-data installed?)";
    return nullptr;
  }
  return server;
}

XServer::~XServer() {
  // SIGTERM lets it remove its socket and lock from /tmp.
  kill(process_, SIGTERM);
  const Clock::time_point end = Clock::now() + longest_stop;
  while (waitpid(process_, nullptr, WNOHANG) == 0) {
    if (Clock::now() > end) kill(process_, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace lrcs
