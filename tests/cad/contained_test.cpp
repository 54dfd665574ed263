#include "cad/contained.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "base/input_error.h"

namespace lrcs {
namespace {

std::string complaint_of(const std::function<std::string()>& work, const ReaderLimits& limits = {}) {
  try {
    (void)contained("a.step", limits, work);
    return "none";
  } catch (const InputError& wrong) {
    return wrong.what();
  }
}

TEST(Contained, GivesTheBytesBack) {
  const std::string all{"x\0\n\xff", 4};
  EXPECT_EQ(contained("a.step", {}, [&] { return all; }), all);
  EXPECT_EQ(contained("a.step", {}, [] { return std::string(); }), "");
  EXPECT_EQ(contained("a.step", {}, [] { return std::string(100'000'000, 'y'); }).size(), 100'000'000U);
}

TEST(Contained, TellsWhatWentWrong) {
  EXPECT_EQ(complaint_of([]() -> std::string { throw InputError("a.step:3:1: wrong"); }), "a.step:3:1: wrong");
  EXPECT_EQ(complaint_of([]() -> std::string { throw std::runtime_error("no"); }), "a.step: cannot be read: no");
  EXPECT_EQ(complaint_of([]() -> std::string { throw 7; }), "a.step: cannot be read: an unknown error");
}

TEST(Contained, OutlivesASignal) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL}) {
    const std::string complaint = complaint_of([=]() -> std::string {
      std::raise(signal);
      return "";
    });
    EXPECT_EQ(complaint.rfind("a.step: its reader broke down (", 0), 0U) << complaint;
  }
}

TEST(Contained, OutlivesAnExit) {
  EXPECT_EQ(complaint_of([]() -> std::string { _exit(3); }), "a.step: its reader broke down: damaged?");
}

TEST(Contained, EndsWhatRunsForEver) {
  volatile bool always = true;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(complaint_of(
                [&]() -> std::string {
                  while (always) {}
                  return "";
                },
                {.processor_s = 1.0}),
            "a.step: its reader was not done after 1 s of processor time: damaged?");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(Contained, EndsWhatWaitsForEver) {
  EXPECT_EQ(complaint_of(
                []() -> std::string {
                  for (;;) pause();
                },
                {.processor_s = 0.1}),
            "a.step: its reader was not done after 1 s: does it wait for something?");
}

TEST(Contained, TellsAProgramThatIsNotWholeFromAWrongFile) {
  EXPECT_THROW((void)contained("a.step", {}, []() -> std::string { throw ReaderNotLoaded("no library"); }),
               ReaderNotLoaded);
}

TEST(Contained, EndsWhatTakesTooMuchMemory) {
  EXPECT_EQ(complaint_of(
                [] {
                  std::vector<std::string> all;
                  for (;;) all.emplace_back(10'000'000, 'x');
                  return std::string();
                },
                {.memory = std::size_t{200} << 20U}),
            "a.step: its reader wanted more than 200 MB of memory: damaged?");
}

TEST(Contained, ThrowsAwayWhatIsPrinted) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(contained("a.step", {},
                      [] {
                        std::puts("noise");
                        std::fflush(stdout);
                        return std::string("b");
                      }),
            "b");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace lrcs
