#include <gmock/gmock.h>

#include <numbers>

#include "brdf/brdf_form.h"
#include "brdf/brdf_table.h"
#include "brdf/library.h"
#include "measured_files.h"

namespace lrcs {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

using std::numbers::pi;

TEST(CsvReader, TakesAnglesAsTheyStand) {
  const auto m =
      measurement_of("# wavelength: 1.06 um\n" + std::string(csv_header) + "10,20,30,0.25\n\n40,50,60,0.125\n");
  ASSERT_EQ(m.samples.size(), 2U);
  EXPECT_EQ(m.name, "a.txt");
  EXPECT_EQ(m.format, "CSV");
  EXPECT_EQ(m.wavelength, 1.06e-6);
  EXPECT_DOUBLE_EQ(m.samples[0].theta_i, 10 * degree);
  EXPECT_DOUBLE_EQ(m.samples[0].theta_r, 20 * degree);
  EXPECT_DOUBLE_EQ(m.samples[0].phi, 30 * degree);
  EXPECT_EQ(m.samples[0].f_r, 0.25);
  EXPECT_EQ(m.samples[0].weight, 1.0);
  EXPECT_EQ(m.samples[0].line, 3);
  EXPECT_EQ(m.samples[1].line, 5);
  EXPECT_THAT(m.warnings, IsEmpty());
}

TEST(CsvReader, FindsColumnsByTheirNames) {
  const auto m =
      measurement_of("G,f_r_per_sr,\"Phi_deg\",theta_r_deg,weight,theta_i_deg\nx,0.5,30,20,2,10\n,1,31,21,3,11");
  ASSERT_EQ(m.samples.size(), 2U);
  EXPECT_DOUBLE_EQ(m.samples[1].theta_i, 11 * degree);
  EXPECT_DOUBLE_EQ(m.samples[1].theta_r, 21 * degree);
  EXPECT_DOUBLE_EQ(m.samples[1].phi, 31 * degree);
  EXPECT_EQ(m.samples[1].f_r, 1.0);
  EXPECT_EQ(m.samples[1].weight, 3.0);
}

TEST(CsvReader, TakesANegativeZenithForTheOtherSideOfTheNormal) {
  const auto m = measurement_of(csv_header + std::string("10,-20,0,1\n-10,20,0,1\n-10,-20,30,1\n10,-20,-90,1\n"));
  EXPECT_DOUBLE_EQ(m.samples[0].theta_r, 20 * degree);
  EXPECT_DOUBLE_EQ(m.samples[0].phi, pi);
  EXPECT_DOUBLE_EQ(m.samples[1].theta_i, 10 * degree);
  EXPECT_DOUBLE_EQ(m.samples[1].phi, pi);
  EXPECT_DOUBLE_EQ(m.samples[2].phi, 30 * degree);
  EXPECT_DOUBLE_EQ(m.samples[3].phi, 90 * degree);
}

TEST(CsvReader, KeepsPhiAboveMinus180AndUpTo180) {
  const auto m = measurement_of(csv_header + std::string("10,20,-180,1\n20,20,180,1\n20,20,540,1\n20,20,270,1\n"));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(m.samples[static_cast<std::size_t>(k)].phi, pi);
  EXPECT_DOUBLE_EQ(m.samples[3].phi, -pi / 2);
}

TEST(CsvReader, TurnsPhiWhereTheSpecularDirectionIsAtZero) {
  const std::string rows = csv_header + std::string("10,10,0,5\n20,10,180,1\n");
  const MeasurementOptions zero{0, {}};
  for (const auto& m : {measurement_of("# azimuth_of_specular: 0\n" + rows), measurement_of(rows, zero)}) {
    EXPECT_EQ(m.samples[0].phi, pi);
    EXPECT_NEAR(m.samples[1].phi, 0.0, 1e-15);
  }
}

TEST(CsvReader, DividesByTheCosineWhereTheValueHasIt) {
  const std::string rows = csv_header + std::string("10,60,0,0.5\n20,0,0,1\n");
  const MeasurementOptions cosine{{}, true};
  for (const auto& m : {measurement_of("# value: brdf_cosine\n" + rows), measurement_of(rows, cosine)}) {
    EXPECT_DOUBLE_EQ(m.samples[0].f_r, 1.0);
    EXPECT_DOUBLE_EQ(m.samples[1].f_r, 1.0);
  }
}

TEST(CsvReader, SaysWhichConventionItReadAndWhoSaidSo) {
  const std::string rows = csv_header + std::string("10,60,0,0.5\n");
  EXPECT_THAT(measurement_of(rows).notes, ElementsAre("azimuth of specular: 180 deg (the file says nothing)",
                                                      "value: f_r (the file says nothing)"));
  EXPECT_THAT(measurement_of("#azimuth_of_specular:0\n" + rows, {{}, true}).notes,
              ElementsAre("azimuth of specular: 0 deg (the file says so)",
                          "value: f_r cos theta_r, divided by the cosine (asked for)"));
}

TEST(CsvReader, LeavesOutAndCountsWhatIsAt90Degrees) {
  const auto m = measurement_of(csv_header + std::string("10,90,0,1\n90,10,0,1\n10,-90,0,1\n10,80,0,1\n"));
  EXPECT_EQ(m.samples.size(), 1U);
  EXPECT_THAT(m.notes, Contains("3 values at 90 deg from the normal, where the cosine is 0, left out"));
}

TEST(CsvReader, TakesAnyLineEndAndAByteOrderMark) {
  const std::string lf = "# wavelength: 532 nm\n" + std::string(csv_header) + "10,20,30,0.5\n11,20,30,0.5\n";
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text = "\xef\xbb\xbf";
    for (const char c : lf) text += c == '\n' ? end : std::string(1, c);
    const auto m = measurement_of(text);
    EXPECT_EQ(m.samples.size(), 2U);
    EXPECT_EQ(m.samples[1].line, 4);
    EXPECT_EQ(m.wavelength, 5.32e-7);
  }
}

TEST(CsvReader, KeepsARepeatedDirectionWithAnotherValue) {
  EXPECT_EQ(measurement_of(csv_header + std::string("10,20,0,1\n10,20,0,2\n30,20,0,1\n")).samples.size(), 3U);
}

TEST(CsvReader, ReadsWhatTheBrdfVerbWrites) {
  const Material& paint = material_library().front();
  const auto m = measurement_of(brdf_table(paint, {0.0, 30.0, 60.0}));
  ASSERT_EQ(m.samples.size(), 3U * 17U);
  EXPECT_EQ(m.wavelength, paint.wavelength);
  for (const BrdfSample& s : m.samples) {
    const double f_r = f_r_angles(paint.brdf, s.theta_i, s.theta_r, s.phi);
    EXPECT_NEAR(s.f_r, f_r, 1e-6 * f_r);
  }
}

TEST(CsvReader, TakesAWavelengthFromWordsAndSaysSo) {
  const std::string rows = csv_header + std::string("10,60,0,0.5\n");
  const auto m = measurement_of("# red laser (650 nm, 3.5mm spot diam.)\n" + rows);
  EXPECT_EQ(m.wavelength, 6.5e-7);
  EXPECT_THAT(m.notes, Contains("wavelength 0.65 um from the words of line 1"));
  EXPECT_EQ(measurement_of("# spot of 650 nm\n" + rows).wavelength, 0.0);
  EXPECT_EQ(measurement_of("# laser of 3.5 mm\n" + rows).wavelength, 0.0);
  EXPECT_EQ(measurement_of("# lasers: 532 nm and 1064 nm\n" + rows).wavelength, 0.0);
  EXPECT_EQ(measurement_of("# laser 1: 532 nm\n# laser 2: 1064 nm\n" + rows).wavelength, 0.0);
}

TEST(CsvWarnings, NameOneAngleOfIncidence) {
  EXPECT_THAT(measurement_of(csv_header + std::string("10,60,0,0.1\n10,20,0,0.1\n")).warnings,
              ElementsAre("only one angle of incidence, 10 deg: what changes with it is not determined"));
}

TEST(CsvWarnings, NameAnglesThatLookLikeRadians) {
  EXPECT_THAT(measurement_of(csv_header + std::string("0.2,1.2,0,0.1\n0.9,1.5,3.1,0.1\n")).warnings,
              ElementsAre("no theta_i passes 0.9 deg: look like radians, expected degrees",
                          "no theta_r passes 1.5 deg: look like radians, expected degrees",
                          "no phi passes 3.1 deg: look like radians, expected degrees"));
}

TEST(CsvWarnings, NameOneColumnOfAnglesThatLooksLikeRadians) {
  EXPECT_THAT(measurement_of(csv_header + std::string("0.2,12,0,0.1\n0.9,-15,180,0.1\n")).warnings,
              ElementsAre("no theta_i passes 0.9 deg: look like radians, expected degrees"));
  EXPECT_THAT(measurement_of(csv_header + std::string("20,12,0,0.1\n-30,15,3.14159,0.1\n")).warnings,
              ElementsAre("no phi passes 3.14 deg: look like radians, expected degrees"));
  EXPECT_THAT(measurement_of(csv_header + std::string("20,12,0,0.1\n-30,15,5,0.1\n")).warnings, ElementsAre());
}

TEST(CsvWarnings, NameASurfaceBrighterThanWhite) {
  EXPECT_THAT(
      measurement_of(csv_header + std::string("10,60,0,1\n30,20,0,1\n30,40,0,1\n")).warnings,
      ElementsAre("pi times the median of f_r is 3.14, more than a white surface has: is the value relative to a "
                  "white standard, or in percent?"));
}

TEST(BadCsv, SaysWhereAKeyHasAnEqualsSign) {
  EXPECT_EQ(complaint_about("# value = brdf_cosine\n" + std::string(csv_header) + "10,60,0,1\n"),
            "a.txt:1:1: expected 'value: ...', found '='");
  EXPECT_EQ(measurement_of("# gain = 3\n" + std::string(csv_header) + "10,60,0,1\n20,60,0,1\n").samples.size(), 2U);
}

TEST(MeasuredAt, TakesTheNearestWavelength) {
  std::vector<BrdfMeasurement> all(2);
  all[0].wavelength = 1.05904e-6;
  all[1].wavelength = 1.06e-6;
  EXPECT_EQ(measured_at(all, 1.06e-6), &all[1]);
  EXPECT_EQ(measured_at(all, 1.0592e-6), &all[0]);
  EXPECT_EQ(measured_at(all, 1.07e-6), nullptr);
  EXPECT_EQ(measured_at({}, 1.06e-6), nullptr);
}

}  // namespace
}  // namespace lrcs
