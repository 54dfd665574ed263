#include "view/x_server.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include "png_pixels.h"

namespace lrcs {
namespace {

// Neither gone nor a zombie that nobody has waited for yet.
bool runs(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(stat, text);
  const std::size_t name_end = text.rfind(") ");
  return name_end != std::string::npos && text[name_end + 2] != 'Z';
}

bool ends_within_seconds(pid_t process, int seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  while (runs(process) && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return !runs(process);
}

TEST(XServer, EndsWithItsObject) {
  std::string why;
  auto server = XServer::start(&why);
  ASSERT_NE(server, nullptr) << why;
  const pid_t process = server->process();
  EXPECT_TRUE(runs(process));
  EXPECT_EQ(server->display().front(), ':');
  server.reset();
  EXPECT_FALSE(runs(process));
}

TEST(XServer, EndsWithAProcessThatIsKilled) {
  std::array<int, 2> channel{};
  ASSERT_EQ(pipe(channel.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    std::string why;
    const auto server = XServer::start(&why);
    const pid_t process = server ? server->process() : 0;
    if (write(channel[1], &process, sizeof process) != sizeof process) _exit(1);
    // An X server that is just about to wait for its first client may miss a signal.
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    kill(getpid(), SIGKILL);
  }
  pid_t process = 0;
  ASSERT_EQ(read(channel[0], &process, sizeof process), static_cast<ssize_t>(sizeof process));
  waitpid(child, nullptr, 0);
  close(channel[0]);
  close(channel[1]);
  ASSERT_GT(process, 0);
  EXPECT_TRUE(ends_within_seconds(process, 5));
}

TEST(XServer, RunsBesideOthers) {
  std::string why;
  const auto first = XServer::start(&why);
  const auto second = XServer::start(&why);
  ASSERT_NE(first, nullptr) << why;
  ASSERT_NE(second, nullptr) << why;
  EXPECT_NE(first->display(), second->display());
}

TEST(XServer, SaysThatAProgramDoesNotStart) {
  const auto fake = scratch_file("Xvfb");
  std::ofstream(fake) << "#!/bin/sh\nexit 1\n";
  std::filesystem::permissions(fake, std::filesystem::perms::owner_all);
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        setenv("PATH", fake.parent_path().c_str(), 1);
        std::string why;
        const auto server = XServer::start(&why);
        std::exit(server == nullptr && why.find("does not start") != std::string::npos ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace lrcs
