#include "view/brdf_axes.h"

#include <gtest/gtest.h>

namespace lrcs {
namespace {

std::vector<std::string> labels_of(double low, double high) {
  return f_r_axis({low, high}, {low, high}, ValueScale::logarithmic).labels;
}

TEST(LogarithmicAxis, WritesAllItsDecadesOneWay) {
  EXPECT_EQ(labels_of(0.001, 1.0), (std::vector<std::string>{"0.001", "0.01", "0.1", "1"}));
  EXPECT_EQ(labels_of(10.0, 1e4), (std::vector<std::string>{"1e1", "1e2", "1e3", "1e4"}));
  EXPECT_EQ(labels_of(1e-4, 0.1), (std::vector<std::string>{"1e−4", "1e−3", "1e−2", "1e−1"}));
}

TEST(LogarithmicAxis, HasEightShortMarksADecade) {
  const Axis axis = f_r_axis({0.01, 10.0}, {0.01, 10.0}, ValueScale::logarithmic);
  ASSERT_EQ(axis.minor_marks.size(), 8U * (axis.marks.size() - 1));
  EXPECT_DOUBLE_EQ(axis.minor_marks.front(), 0.02);
  EXPECT_DOUBLE_EQ(axis.minor_marks.back(), 9.0);
}

TEST(SymmetricAxis, EndsAtItsReachAndMarksBothSides) {
  for (double reach = 1e-4; reach < 1e6; reach *= 1.07) {
    const Axis axis = symmetric_axis("", reach);
    EXPECT_EQ(axis.low, -reach);
    EXPECT_EQ(axis.high, reach);
    EXPECT_GE(axis.marks.size(), 3U) << reach;
    EXPECT_LE(axis.marks.size(), 5U) << reach;
    EXPECT_LE(axis.marks.back(), reach * (1.0 + 1e-9));
  }
}

}  // namespace
}  // namespace lrcs
