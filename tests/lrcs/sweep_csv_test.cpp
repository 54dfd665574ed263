#include "lrcs/sweep_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

using testing::HasSubstr;

std::vector<SweepRow> some_rows() {
  return {{aspect_between({0.1, -3}, {0.1, -3}), {1.0 / 3.0, 1e-17}, 0.25},
          {aspect_between({359, 90}, {2, 1}), {0.0, 0.0}, 0.0},
          {aspect_between({-7, 0}, {-7, 0}), {std::numeric_limits<double>::denorm_min(), 3e300}, 5.0}};
}

class SweepCsv : public testing::Test {
 protected:
  std::string complaint(const std::string& text) const {
    folder_.write("sweep.csv", text);
    try {
      (void)read_sweep_csv(folder_.path() / "sweep.csv");
      return "none";
    } catch (const InputError& wrong) {
      return std::string(wrong.what()).substr(folder_.path().string().size() + 1);
    }
  }
  ScratchFolder folder_;
};

TEST_F(SweepCsv, ReadsBackTheSameDoubles) {
  const auto rows = some_rows();
  folder_.write("sweep.csv", sweep_csv(Scene(), "digest", rows));
  const auto again = read_sweep_csv(folder_.path() / "sweep.csv");
  ASSERT_EQ(again.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(again[k].aspect.transmitter, rows[k].aspect.transmitter);
    EXPECT_EQ(again[k].aspect.receiver, rows[k].aspect.receiver);
    EXPECT_EQ(again[k].sigma.value, rows[k].sigma.value);
    EXPECT_EQ(again[k].sigma.bound, rows[k].sigma.bound);
    EXPECT_EQ(again[k].seen_area, rows[k].seen_area);
  }
}

TEST_F(SweepCsv, SaysWhereAFileIsNone) {
  const std::string whole = sweep_csv(Scene(), "digest", some_rows());
  const std::string header = whole.substr(0, whole.find("0.1,-3"));
  EXPECT_THAT(complaint(""), HasSubstr("expected the columns of a sweep.csv"));
  EXPECT_THAT(complaint("facet,zone\n1,2\n"), HasSubstr("sweep.csv:1:1: expected the column transmitter_azimuth_deg"));
  EXPECT_THAT(complaint(header), HasSubstr("expected a row of numbers"));
  EXPECT_THAT(complaint(header + "1,2,3,4,x,0,0,0\n"), HasSubstr(":9: "));
  EXPECT_THAT(complaint(header + "1,2,3,4,-5,0,0,0\n"), HasSubstr("expected sigma_m2 of 0 or more, found -5"));
  EXPECT_THAT(complaint(header + "1,2,3,4,nan,0,0,0\n"), HasSubstr("expected a finite number"));
  EXPECT_THAT(complaint(header + "1,2,3,4\n"), HasSubstr("expected sigma_m2"));
  EXPECT_THAT(complaint(header + "1,2,3,4,5,6,7,8,9\n"), HasSubstr("expected 8 cells, found more"));
}

}  // namespace
}  // namespace lrcs
