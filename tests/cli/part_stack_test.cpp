#include "cli/part_stack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/cli/program.h"

namespace lrcs {
namespace {

// An assembly with more parts than layers, every 40 deg.
class PartStack : public testing::Test {
 protected:
  PartStack() {
    const Outcome swept = run_lrcs({"sweep", LRCS_EXAMPLES "/as1/as1-oc-214.stp", "--material", "lambert:0.5",
                                    "--azimuth", "0:320:40", "--elevation", "20", "-o", "out", "-q"},
                                   {folder_.path()});
    EXPECT_EQ(swept.status, 0) << swept.err;
    run_ = read_past_run(folder_.path() / "out");
    cut_.rows.resize(run_.rows.size());
    std::iota(cut_.rows.begin(), cut_.rows.end(), 0);
    for (const SweepRow& row : run_.rows) cut_.curve.angle_deg.push_back(row.aspect.transmitter.azimuth_deg);
  }
  ScratchFolder folder_;
  PastRun run_;
  ViewedCut cut_;
};

TEST_F(PartStack, AddsUpToSigmaOfTheSweep) {
  const LayerStack stack = part_stack(run_, cut_, 2, {});
  const std::vector<double> top = stack_top(stack);
  ASSERT_EQ(top.size(), 9U);
  for (std::size_t i = 0; i < top.size(); ++i) {
    const double sigma = run_.rows[i].sigma.value;
    EXPECT_NEAR(top[i], sigma, 1e-12 * sigma) << i;
  }
}

TEST_F(PartStack, HasTheSevenStrongestPartsAndTheRest) {
  const LayerStack stack = part_stack(run_, cut_, 2, {});
  ASSERT_EQ(stack.layers.size(), 7U);
  const auto sum = [](const std::vector<double>& sigma) { return std::accumulate(sigma.begin(), sigma.end(), 0.0); };
  for (std::size_t k = 1; k < stack.layers.size(); ++k)
    EXPECT_GE(sum(stack.layers[k - 1].sigma_m2), sum(stack.layers[k].sigma_m2));
  ASSERT_EQ(stack.others_m2.size(), 9U);
  EXPECT_GT(sum(stack.others_m2), 0.0);
  const auto& names = run_.loaded.target.mesh.part.names;
  for (const StackLayer& layer : stack.layers) EXPECT_EQ(std::count(names.begin(), names.end(), layer.label), 1);
}

TEST_F(PartStack, OfAnotherTargetIsAnError) {
  run_.rows[3].sigma.value *= 1.0 + 1e-6;
  EXPECT_THROW((void)part_stack(run_, cut_, 2, {}), std::runtime_error);
}

TEST_F(PartStack, ReportsEveryRow) {
  std::size_t last = 0;
  (void)part_stack(run_, cut_, 1, [&](std::size_t done) { last = done; });
  EXPECT_EQ(last, 9U);
}

}  // namespace
}  // namespace lrcs
