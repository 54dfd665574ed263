#include "cli/part_stack.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/vec3.h"
#include "tests/cli/program.h"

namespace lrcs {
namespace {

// Nine triangles side by side, areas 0.5 to 4.5 m^2, from the front to 60 deg off it.
class PartStack : public testing::Test {
 protected:
  PartStack() {
    std::string text;
    for (int k = 1; k <= 9; ++k)
      text += fmt::format("o part{0}\nv 0 0 {1}\nv 0 {0} {1}\nv 0 0 {2}\nf -3 -2 -1\n", k, 10 * k, 10 * k + 1);
    folder_.write("nine.obj", text);
    const Outcome swept = run_lrcs(
        {"sweep", "nine.obj", "--unit", "m", "--material", "lambert:0.5", "--azimuth", "0:60:20", "-o", "out", "-q"},
        {folder_.path()});
    EXPECT_EQ(swept.status, 0) << swept.err;
    run_ = read_past_run(folder_.path() / "out");
    cut_.rows = {0, 1, 2, 3};
    cut_.curve.angle_deg = {0.0, 20.0, 40.0, 60.0};
  }
  // 4 rho A cos^2
  [[nodiscard]] double sigma(double area, std::size_t row) const {
    return 4.0 * 0.5 * area * std::pow(std::cos(cut_.curve.angle_deg[row] * degree), 2);
  }
  ScratchFolder folder_;
  PastRun run_;
  ViewedCut cut_;
};

TEST_F(PartStack, AddsUpToSigmaOfTheSweep) {
  std::size_t last = 0;
  const std::vector<double> top = stack_top(part_stack(run_, cut_, 2, [&](std::size_t done) { last = done; }));
  ASSERT_EQ(top.size(), 4U);
  for (std::size_t row = 0; row < top.size(); ++row) {
    const double swept = run_.rows[row].sigma.value;
    EXPECT_NEAR(top[row], swept, 1e-12 * swept);
    EXPECT_NEAR(top[row], sigma(22.5, row), 1e-12 * swept);
  }
  EXPECT_EQ(last, 4U);
}

TEST_F(PartStack, HasTheSevenStrongestPartsAndTheRest) {
  const LayerStack stack = part_stack(run_, cut_, 2, {});
  ASSERT_EQ(stack.layers.size(), 7U);
  for (std::size_t row = 0; row < 4; ++row) {
    for (int k = 0; k < 7; ++k) {
      const StackLayer& layer = stack.layers[static_cast<std::size_t>(k)];
      EXPECT_EQ(layer.label, "part" + std::to_string(9 - k));
      EXPECT_NEAR(layer.sigma_m2[row], sigma(0.5 * (9 - k), row), 1e-12);
    }
    EXPECT_NEAR(stack.others_m2.at(row), sigma(1.5, row), 1e-12);
  }
}

TEST_F(PartStack, ThatIsNotTheSweepsSigmaIsAnError) {
  run_.rows[3].sigma.value *= 1.0 + 1e-6;
  EXPECT_THROW((void)part_stack(run_, cut_, 2, {}), std::runtime_error);
}

}  // namespace
}  // namespace lrcs
