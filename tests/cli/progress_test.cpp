// What a sweep says while it runs, to a terminal and elsewhere.
#include "cli/progress_bar.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

class Progress : public testing::Test {
 protected:
  Progress() {
    folder_.write("box.stl", two_boxes());
    folder_.write("scene.yaml", good_scene);
  }
  ScratchFolder folder_;
  const std::vector<std::string> sweep_{"sweep", "scene.yaml"};
  const std::vector<std::string> quietly_{"sweep", "scene.yaml", "-q"};
};

// Bare containers have no pseudo-terminals; the bar's text is tested there too (ProgressText).
class ProgressOnATerminal : public Progress {
 protected:
  void SetUp() override {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0) GTEST_SKIP() << "this system has no pseudo-terminals: " << std::strerror(errno);
    close(terminal);
  }
};

TEST_F(ProgressOnATerminal, IsABarWithRateAndTimeLeft) {
  const Outcome outcome = run_lrcs_on_terminal(sweep_, {folder_.path()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("\r\033[K[==============================] 5/5 directions  "), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("/s  0:00 left"), std::string::npos);
}

TEST_F(ProgressOnATerminal, IsNothingAtAllWhenQuiet) {
  EXPECT_EQ(run_lrcs_on_terminal(quietly_, {folder_.path()}).out, "");
}

TEST(ProgressText, HasShareRateAndTimeLeft) {
  EXPECT_EQ(progress_text(90, 360, 45.0, "directions"),
            "[=======                       ] 90/360 directions  2/s  2:15 left");
  EXPECT_EQ(progress_text(0, 360, 0.0, "directions"), "[                              ] 0/360 directions");
}

TEST(ProgressText, WritesTimesAsAClock) {
  EXPECT_EQ(clock_text(0.4), "0:00");
  EXPECT_EQ(clock_text(75.0), "1:15");
  EXPECT_EQ(clock_text(3725.0), "1:02:05");
}

TEST_F(Progress, IsNoBarElsewhere) {
  const Outcome outcome = run_lrcs(sweep_, {folder_.path()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.find_first_of("\r\033["), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("lrcs: repaired: 56 repeated vertices welded"), std::string::npos);
  EXPECT_NE(outcome.err.find("lrcs: 5 directions in "), std::string::npos);
}

TEST_F(Progress, IsNothingAtAllWhenQuiet) {
  const Outcome outcome = run_lrcs(quietly_, {folder_.path()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(Progress, SaysMoreWhenVerbose) {
  const Outcome outcome = run_lrcs({"sweep", "scene.yaml", "-v", "-t", "2"}, {folder_.path()});
  EXPECT_NE(outcome.err.find("lrcs: 24 facets in 2 parts, 5 directions, 2 threads\n"), std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace lrcs
