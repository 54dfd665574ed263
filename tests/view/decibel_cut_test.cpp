#include "view/decibel_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lrcs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> angles_of(const std::vector<double>& given) {
  std::vector<double> angles;
  for (const CutPoint& p : cut_points({"", given, std::vector<double>(given.size(), 1.0)}))
    angles.push_back(p.angle_deg);
  return angles;
}

using Angles = std::vector<double>;

TEST(CutPoints, KeepASweepThatRunsOneWay) {
  EXPECT_EQ(angles_of({-30, 0, 15, 17}), (Angles{-30, 0, 15, 17}));
  EXPECT_EQ(angles_of({40, 10, -5}), (Angles{40, 10, -5}));
  EXPECT_EQ(angles_of({5}), (Angles{5}));
  EXPECT_EQ(angles_of({}), (Angles{}));
}

TEST(CutPoints, RunOnPastAFullTurn) {
  EXPECT_EQ(angles_of({340, 350, 0, 10}), (Angles{340, 350, 360, 370}));
  EXPECT_EQ(angles_of({10, 0, 350, 340}), (Angles{10, 0, -10, -20}));
}

TEST(CutPoints, AreSortedWhereTheDirectionsJumpAbout) {
  EXPECT_EQ(angles_of({10, 50, 20, 40, 30}), (Angles{10, 20, 30, 40, 50}));
}

TEST(CutPoints, CloseASweepThatGoesAllAround) {
  EXPECT_EQ(angles_of({0, 60, 120, 180, 240, 300}).back(), 360.0);
  EXPECT_EQ(angles_of({-180, -120, -60, 0, 60, 120}).back(), 180.0);
  EXPECT_EQ(angles_of({300, 240, 180, 120, 60, 0}).back(), -60.0);
}

TEST(CutPoints, LeaveASweepOpenThatDoesNotComeBack) {
  EXPECT_EQ(angles_of({0, 10, 20, 330}).size(), 5U);
  EXPECT_EQ(angles_of({0, 60, 120, 180, 240}).size(), 5U);
  EXPECT_EQ(angles_of({0, 90, 180, 270}).size(), 4U);
  EXPECT_EQ(angles_of({0, 120, 240, 360}).size(), 4U);
}

TEST(CutPoints, OfRowsOnlyRise) {
  Curve rows{"", {}, {}};
  for (int k = 0; k < 360; ++k) rows.angle_deg.push_back(k), rows.sigma_m2.push_back(1.0);
  EXPECT_EQ(cut_points(rows).back().angle_deg, 360.0);
  EXPECT_EQ(cut_points(rows, false).back().angle_deg, 359.0);
}

TEST(CutPoints, AreInDecibels) {
  const auto cut = cut_points({"", {0, 1, 2}, {100.0, 1.0, 0.0}});
  EXPECT_DOUBLE_EQ(cut[0].dbsm, 20.0);
  EXPECT_DOUBLE_EQ(cut[1].dbsm, 0.0);
  EXPECT_EQ(cut[2].dbsm, -infinity);
}

TEST(DecibelRange, SpansThePointsOnWholeSteps) {
  const DecibelRange range = decibel_range({{{0, -23.0}, {1, 4.0}}}, 10.0);
  EXPECT_LE(range.low, -23.0);
  EXPECT_GE(range.high, 4.0);
  EXPECT_DOUBLE_EQ(std::remainder(range.low, range.step), 0.0);
  EXPECT_DOUBLE_EQ(std::remainder(range.high, range.step), 0.0);
  EXPECT_FALSE(range.floor_used);
}

TEST(DecibelRange, StopsSixtyDecibelsBelowTheHighest) {
  const DecibelRange range = decibel_range({{{0, -200.0}, {1, 3.0}}}, 10.0);
  EXPECT_LE(range.low, -57.0);
  EXPECT_GE(range.low, -80.0);
  EXPECT_TRUE(range.floor_used);
}

TEST(DecibelRange, IsNoNarrowerThanAsked) {
  const DecibelRange range = decibel_range({{{0, 3.0}, {1, 3.0 + 1e-12}}}, 10.0);
  EXPECT_GE(range.high - range.low, 10.0);
  EXPECT_LT(range.low, 3.0);
  EXPECT_GT(range.high, 3.0);
}

TEST(DecibelRange, IsThereWhereNothingReturns) {
  const DecibelRange range = decibel_range({{{0, -infinity}}}, 10.0);
  EXPECT_TRUE(range.all_zero);
  EXPECT_LT(range.low, range.high);
}

TEST(StrokesAbove, EndWhereTheCurveCrossesTheFloor) {
  const auto strokes = strokes_above({{0, 0}, {10, -20}, {20, 0}}, -10.0);
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_DOUBLE_EQ(strokes[0].back().angle_deg, 5.0);
  EXPECT_DOUBLE_EQ(strokes[0].back().dbsm, -10.0);
  EXPECT_DOUBLE_EQ(strokes[1].front().angle_deg, 15.0);
}

TEST(StrokesAbove, BreakBesideAPointThatIsZero) {
  const auto strokes = strokes_above({{0, 0}, {10, 0}, {20, -infinity}, {30, 0}, {40, 0}}, -10.0);
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_EQ(strokes[0].size(), 2U);
  EXPECT_DOUBLE_EQ(strokes[0].back().angle_deg, 10.0);
  EXPECT_DOUBLE_EQ(strokes[1].front().angle_deg, 30.0);
}

}  // namespace
}  // namespace lrcs
