#include <gmock/gmock.h>

#include <fmt/format.h>

#include <numbers>

#include "made_formats.h"
#include "measured_files.h"

namespace lrcs {
namespace {

using testing::Contains;

using std::numbers::pi;

std::string alta(const std::string& param_in, const std::string& param_out, const std::string& rows) {
  return "#DIM 3 1\n#PARAM_IN " + param_in + "\n#PARAM_OUT " + param_out + "\n" + rows;
}

TEST(AltaReader, ProjectsTheViewAngleAlongTheDifferenceOfAzimuths) {
  const auto m = measurement_of(
      alta("ISOTROPIC_TL_TV_PROJ_DPHI", "INV_STERADIAN", "0.25 0.25 0 11\n0.5 -0.3 0 1\n0.5 0.3 0.4 0.2\n"));
  ASSERT_EQ(m.samples.size(), 3U);
  EXPECT_EQ(m.samples[0].theta_i, 0.25);
  EXPECT_EQ(m.samples[0].theta_r, 0.25);
  EXPECT_EQ(m.samples[0].phi, 0.0);  // retro
  EXPECT_EQ(m.samples[1].theta_r, 0.3);
  EXPECT_EQ(m.samples[1].phi, pi);
  EXPECT_DOUBLE_EQ(m.samples[2].theta_r, 0.5);
  EXPECT_DOUBLE_EQ(m.samples[2].phi, std::atan2(0.4, 0.3));
  EXPECT_EQ(m.samples[2].f_r, 0.2);
}

TEST(AltaReader, DividesByTheCosineOfTheViewDirection) {
  const auto m = measurement_of(alta("ISOTROPIC_TL_TV_PROJ_DPHI", "INV_STERADIAN_COSINE_FACTOR",
                                     fmt::format("0.25 {} 0 0.5\n0.25 0 {} 1\n", pi / 3, pi / 2)));
  ASSERT_EQ(m.samples.size(), 1U);
  EXPECT_NEAR(m.samples[0].f_r, 1.0, 1e-15);
  EXPECT_THAT(m.notes, Contains("value: f_r cos theta_r, divided by the cosine (the file says so)"));
  EXPECT_THAT(m.notes, Contains("1 value at 90 deg from the normal, where the cosine is 0, left out"));
}

TEST(AltaReader, TakesTheOrderOfAnglesFromTheNameOfTheParametrisation) {
  const auto view_first = measurement_of(alta("ISOTROPIC_TV_TL_DPHI", "INV_STERADIAN", "0.1 0.2 3 1\n"));
  EXPECT_EQ(view_first.samples[0].theta_i, 0.2);
  EXPECT_EQ(view_first.samples[0].theta_r, 0.1);
  EXPECT_EQ(view_first.samples[0].phi, 3.0);
}

TEST(AltaReader, ReadsHalfAndDifferenceAngles) {
  const auto m = measurement_of(alta("RUSIN_TH_TD_PD", "INV_STERADIAN", "0.3 0 0 1\n0 0.2 1 2\n0.1 0.25 0 3\n"));
  EXPECT_NEAR(m.samples[0].theta_i, 0.3, 1e-14);
  EXPECT_NEAR(m.samples[0].theta_r, 0.3, 1e-14);
  EXPECT_NEAR(m.samples[0].phi, 0.0, 1e-14);  // no difference: retro
  EXPECT_NEAR(m.samples[1].theta_i, 0.2, 1e-14);
  EXPECT_NEAR(m.samples[1].phi, pi, 1e-14);  // half vector at the normal: specular
  EXPECT_NEAR(m.samples[2].theta_r, 0.35, 1e-14);
  EXPECT_NEAR(m.samples[2].theta_i, 0.15, 1e-14);
}

TEST(AltaReader, PassesOverIntervals) {
  const auto m = measurement_of("#VS 2\n" + alta("ISOTROPIC_TV_TL_DPHI", "INV_STERADIAN", "0.1 0.2 3 1 0.9 1.1\n"));
  EXPECT_EQ(m.samples[0].f_r, 1.0);
  EXPECT_THAT(m.notes, Contains("2 columns of intervals not read"));
}

TEST(BadAlta, SaysWhereItContradictsItself) {
  EXPECT_EQ(complaint_about("#PARAM_IN RUSIN_TH_TD_PD\n" + alta("ISOTROPIC_TV_TL_DPHI", "INV_STERADIAN", "")),
            "a.txt:3:11: line 1 says another PARAM_IN, expected one");
  EXPECT_EQ(complaint_about("#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n" + alta("RUSIN_TH_TD_PD", "INV_STERADIAN", "")),
            "a.txt:4:12: line 1 says another PARAM_OUT, expected one");
}

TEST(BadAlta, SaysWhatIsNotRead) {
  EXPECT_EQ(complaint_about(alta("COS_TH", "INV_STERADIAN", "")),
            "a.txt:2:11: expected ISOTROPIC_TL_TV_PROJ_DPHI, ISOTROPIC_TV_TL_DPHI or "
            "RUSIN_TH_TD_PD, found 'COS_TH'");
  EXPECT_EQ(complaint_about(alta("RUSIN_TH_TD_PD", "RGB_COLOR", "")),
            "a.txt:3:12: expected INV_STERADIAN or INV_STERADIAN_COSINE_FACTOR, found 'RGB_COLOR'");
  EXPECT_EQ(complaint_about("#DIM 3 3\n"), "a.txt:1:8: expected 1 channel (more are not read), found '3'");
  EXPECT_EQ(complaint_about("#DIM 2 1\n"), "a.txt:1:6: expected 3 angles, found '2'");
  EXPECT_EQ(complaint_about("#DIM 3 1\n#VS 3\n"), "a.txt:2:5: expected VS 0, 1 or 2, found 3");
  EXPECT_EQ(complaint_about("#DIM 3 1\n#FORMAT binary\n"),
            "a.txt:2:9: expected text data (binary ones are not read), found 'binary'");
  EXPECT_EQ(complaint_about("#DIM 3 1\n").substr(0, 50), "a.txt:2:1: no #PARAM_IN in the header, expected IS");
}

TEST(BadAlta, HasRowsThatAreWrong) {
  const auto complaint = [](const std::string& row) {
    return complaint_about(alta("ISOTROPIC_TL_TV_PROJ_DPHI", "INV_STERADIAN", row));
  };
  EXPECT_EQ(complaint("0.1 0.2 0\n"), "a.txt:4:10: expected a number, found nothing");
  EXPECT_EQ(complaint("0.1 0.2 0 1 2\n"), "a.txt:4:13: expected the end of a row of 4, found '2'");
  EXPECT_EQ(complaint("15 15 0 1\n"), "a.txt:4:1: expected an angle from the normal of at most 1.5708 rad, found 15");
  EXPECT_EQ(complaint("0.1 1.2 1.2 1\n"),
            "a.txt:4:9: expected an angle from the normal of at most 1.5708 rad, found the projections of 1.69706");
}

}  // namespace
}  // namespace lrcs
