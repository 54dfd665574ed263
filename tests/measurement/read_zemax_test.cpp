#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "made_formats.h"
#include "measured_files.h"

namespace lrcs {
namespace {

using testing::Contains;

using std::numbers::pi;

const BrdfSample& sample_on_line(const BrdfMeasurement& m, int line, double f_r) {
  return *std::find_if(m.samples.begin(), m.samples.end(),
                       [&](const BrdfSample& s) { return s.line == line && s.f_r == f_r; });
}

TEST(ZemaxReader, CountsRadialAnglesFromTheSpecularRay) {
  const auto m = measurement_of(made_zemax);
  const BrdfSample& specular = m.samples.front();
  EXPECT_NEAR(specular.theta_i, 10 * degree, 1e-15);
  EXPECT_NEAR(specular.theta_r, 10 * degree, 1e-15);
  EXPECT_EQ(specular.phi, pi);
  EXPECT_EQ(specular.f_r, 0.9);
}

TEST(ZemaxReader, HasAzimuthZeroTowardTheNormal) {
  const auto m = measurement_of(made_zemax);
  const BrdfSample& past_the_normal = sample_on_line(m, 18, 0.8);
  EXPECT_NEAR(past_the_normal.theta_r, 10 * degree, 1e-14);
  EXPECT_NEAR(past_the_normal.phi, 0.0, 1e-14);
  const BrdfSample& away = sample_on_line(m, 20, 0.4);
  EXPECT_NEAR(away.theta_r, 30 * degree, 1e-14);
  EXPECT_EQ(away.phi, pi);
}

TEST(ZemaxReader, TurnsAzimuthsAroundTheSpecularRay) {
  const auto m = measurement_of(made_zemax);
  const BrdfSample& aside = sample_on_line(m, 19, 0.6);
  EXPECT_NEAR(std::cos(aside.theta_r), std::cos(10 * degree) * std::cos(20 * degree), 1e-14);
  EXPECT_NEAR(toward(aside.theta_r, aside.phi).dot(toward(10 * degree, pi)), std::cos(20 * degree), 1e-14);
}

TEST(ZemaxReader, LeavesOutWhatIsBelowTheSurfaceOrZeroAndRepeatsOfTheSpecularRay) {
  const auto m = measurement_of(made_zemax);
  EXPECT_EQ(std::count_if(m.samples.begin(), m.samples.end(), [](const auto& s) { return s.f_r == 0.9; }), 1);
  EXPECT_THAT(m.notes, Contains("1 value of 0, not measured in this format, left out"));
  const auto below = measurement_of(std::string(made_zemax).replace(made_zemax.find("1.4 0"), 5, "1.4 1"));
  EXPECT_THAT(below.notes, Contains("1 value of directions below the surface, left out"));
  EXPECT_EQ(below.samples.size(), m.samples.size());
}

TEST(ZemaxReader, TakesTheWavelengthFromItsComments) {
  EXPECT_EQ(measurement_of(made_zemax).wavelength, 6.5e-7);
}

std::string made_zemax_with(const std::string& old_text, const std::string& new_text) {
  return std::string(made_zemax).replace(made_zemax.find(old_text), old_text.size(), new_text);
}

TEST(BadZemax, SaysWhatIsNotRead) {
  EXPECT_EQ(complaint_about(made_zemax + "\nDataBegin\n"),
            "a.txt:27:1: expected the end of the file after 'DataEnd', found 'DataBegin'");
  EXPECT_EQ(complaint_about(made_zemax_with("BRDF", "BTDF")),
            "a.txt:5:13: expected BRDF (nothing else is read), found 'BTDF'");
  EXPECT_EQ(complaint_about(made_zemax_with("Content Monochrome", "Content XYZ")),
            "a.txt:4:17: expected Monochrome (nothing else is read), found 'XYZ'");
  EXPECT_EQ(complaint_about(made_zemax_with("SampleRotation 1\n0", "SampleRotation 2\n0 45")),
            "a.txt:6:16: expected 1 sample rotation (more are not read), found 2");
  EXPECT_EQ(complaint_about(made_zemax_with("Source", "Sauce")).substr(0, 20), "a.txt:2:1: expected ");
}

TEST(BadZemax, HasOtherNumbersThanItsHeaderSays) {
  EXPECT_EQ(complaint_about(made_zemax_with("0 20 70", "0 20")),
            "a.txt:15:1: expected a finite number, found 'Monochrome'");
  EXPECT_EQ(complaint_about(made_zemax_with("ScatterRadial 3", "ScatterRadial 99999999")),
            "a.txt:12:15: expected a number of angles that the file can hold, found 99999999");
  EXPECT_EQ(complaint_about(made_zemax_with("10 30\n", "10 91\n")),
            "a.txt:9:4: expected an angle from 0 to 90 deg, found 91");
  EXPECT_EQ(complaint_about(made_zemax_with("0.9 0.6 0.5", "0.9 0.6")), "a.txt:19:8: expected a number, found nothing");
  EXPECT_EQ(complaint_about(made_zemax_with("0.9 0.6 0.5", "0.9 0.6 0.5 1")),
            "a.txt:19:13: expected the end of a row of 3 values, found '1'");
  EXPECT_EQ(complaint_about(made_zemax_with("DataEnd\n", "")),
            "a.txt:25:1: expected 'DataEnd', found the end of the file");
  EXPECT_EQ(complaint_about(made_zemax_with("ScatterAzimuth 3\n0 90 180\n", "")),
            "a.txt:14:1: expected 'ScatterAzimuth' before the data");
}

}  // namespace
}  // namespace lrcs
