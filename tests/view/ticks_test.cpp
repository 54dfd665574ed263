#include "view/ticks.h"

#include <gtest/gtest.h>

#include "view/colour.h"

namespace lrcs {
namespace {

TEST(NiceStep, IsTheSmallestThatLeavesFewEnough) {
  EXPECT_DOUBLE_EQ(nice_step(60.0, 7), 10.0);
  EXPECT_DOUBLE_EQ(nice_step(10.0, 7), 2.0);
  EXPECT_DOUBLE_EQ(nice_step(0.3, 6), 0.05);
  for (const double span : {1e-9, 0.7, 3.0, 123.0, 4e5}) EXPECT_LE(span / nice_step(span, 6), 6.0 + 1e-9) << span;
}

TEST(AngleStep, DividesTheFullTurn) {
  EXPECT_DOUBLE_EQ(angle_step(360.0, 12), 30.0);
  EXPECT_DOUBLE_EQ(angle_step(180.0, 12), 15.0);
  EXPECT_DOUBLE_EQ(angle_step(90.0, 12), 10.0);
  EXPECT_DOUBLE_EQ(angle_step(10.0, 12), 1.0);
  EXPECT_DOUBLE_EQ(angle_step(720.0, 12), 90.0);
}

TEST(Multiples, TakeInBothEnds) {
  EXPECT_EQ(multiples(-10.0, 10.0, 5.0), (std::vector<double>{-10.0, -5.0, 0.0, 5.0, 10.0}));
  EXPECT_EQ(multiples(0.0, 0.3, 0.1).size(), 4U);
  EXPECT_EQ(multiples(1.0, 9.0, 10.0).size(), 0U);
}

TEST(TickLabel, HasTheDigitsOfTheStep) {
  EXPECT_EQ(tick_label(-40.0, 10.0), "−40");
  EXPECT_EQ(tick_label(0.25, 0.05), "0.25");
  EXPECT_EQ(tick_label(-1e-17, 0.1), "0.0");
  EXPECT_EQ(tick_label(3.0, 0.5), "3.0");
}

TEST(Viridis, GrowsLighterThroughout) {
  double before = -1.0;
  for (int i = 0; i <= 100; ++i) {
    const Colour c = viridis(i / 100.0);
    const double lightness = 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue;
    EXPECT_GT(lightness, before) << i;
    before = lightness;
  }
  EXPECT_THROW((void)viridis(1.01), std::domain_error);
}

}  // namespace
}  // namespace lrcs
