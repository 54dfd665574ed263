#include <gtest/gtest.h>

#include <numbers>

#include "made_formats.h"
#include "measured_files.h"

namespace lrcs {
namespace {

TEST(FredReader, HasPhiZeroOnTheSpecularSide) {
  const auto m = measurement_of(made_fred);
  ASSERT_EQ(m.samples.size(), 4U);
  EXPECT_EQ(m.format, "FRED BSDF data");
  EXPECT_DOUBLE_EQ(m.samples[1].theta_i, 10 * degree);
  EXPECT_DOUBLE_EQ(m.samples[1].theta_r, 10 * degree);
  EXPECT_EQ(m.samples[1].phi, std::numbers::pi);
  EXPECT_NEAR(std::abs(m.samples[2].phi), 90 * degree, 1e-15);
  EXPECT_DOUBLE_EQ(m.samples[3].theta_i, 30 * degree);
}

TEST(FredReader, TakesScaleAndRadians) {
  EXPECT_EQ(measurement_of(made_fred).samples[1].f_r, 1.8);
  const auto m = measurement_of("type bsdf_data\nformat angles=rad bsdf=value\n0.2 0\n0.3 1.5 0.1\n");
  EXPECT_EQ(m.samples[0].theta_i, 0.2);
  EXPECT_EQ(m.samples[0].theta_r, 0.3);
  EXPECT_EQ(m.samples[0].f_r, 0.1);
}

TEST(BadFred, SaysWhereARowWasCutOff) {
  const std::string head = "type bsdf_data\nformat angles=deg bsdf=value\n10 0\n0 0 0.1\n30 0\n";
  EXPECT_EQ(complaint_about(head).substr(0, 46), "a.txt:6:1: expected 3 numbers, theta, phi and ");
  EXPECT_EQ(complaint_about(head + "50 0\n0 0 0.1\n").substr(0, 46), "a.txt:6:1: expected 3 numbers, theta, phi and ");
}

TEST(BadFred, SaysWhatIsNotRead) {
  const std::string type = "type bsdf_data\n";
  EXPECT_EQ(complaint_about(type + "format angles=deg bsdf=log10\n"),
            "a.txt:2:19: expected angles=deg, angles=rad, bsdf=value or scale=NUMBER, found 'bsdf=log10'");
  EXPECT_EQ(complaint_about(type + "format bsdf=value\n"),
            "a.txt:2:18: the format says no unit of angles, expected angles=deg or angles=rad");
  EXPECT_EQ(complaint_about(type + "format angles=deg scale=x\n"), "a.txt:2:19: expected a finite number, found 'x'");
  EXPECT_EQ(complaint_about("type bsdf_table\n"), "a.txt:1:6: expected bsdf_data, found 'bsdf_table'");
  EXPECT_EQ(complaint_about(type), "a.txt:2:1: expected 'format', found the end of the file");
}

TEST(BadFred, HasRowsThatAreWrong) {
  const std::string head = "type bsdf_data\nformat angles=deg bsdf=value scale=1\n";
  EXPECT_EQ(complaint_about(head + "1 0 0.5\n"),
            "a.txt:3:1: expected 2 numbers, AOI and azimuth, before the first values");
  EXPECT_EQ(complaint_about(head + "10 5\n"), "a.txt:3:4: expected the azimuth 0 of incidence, others are not read");
  EXPECT_EQ(complaint_about(head + "10 0\n1 2 3 4\n"),
            "a.txt:4:1: expected 2 numbers, AOI and azimuth, or 3, theta, phi and value, found 4");
  EXPECT_EQ(complaint_about(head + "10 0\n1 2 -3\n"), "a.txt:4:5: expected a value that is not negative, found -3");
  EXPECT_EQ(complaint_about(head + "10 0\n95 2 3\n"),
            "a.txt:4:1: expected an angle from the normal of at most 90 deg, found 95");
  EXPECT_EQ(complaint_about(head + "10 0\n"),
            "a.txt:4:1: expected 3 numbers, theta, phi and value, after AOI and azimuth in the row before");
}

}  // namespace
}  // namespace lrcs
