#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "made_formats.h"
#include "measured_files.h"

namespace lrcs {
namespace {

using testing::Contains;

using std::numbers::pi;

TEST(LumosTable, HasPhiAsTheZenith) {
  const auto m = measurement_of(made_lumos);
  ASSERT_EQ(m.samples.size(), 3U);
  EXPECT_DOUBLE_EQ(m.samples[0].theta_r, 75 * degree);
  EXPECT_NEAR(m.samples[0].phi, 0.0, 1e-15);  // the transmitter's side
  EXPECT_EQ(m.samples[1].phi, pi);
  EXPECT_EQ(m.samples[1].f_r, 3.5);
  EXPECT_EQ(m.wavelength, 5.32e-7);
  EXPECT_THAT(m.notes, Contains("phi is the angle from the normal, theta the azimuth"));
}

TEST(NistTable, GivesOneMeasurementAWavelengthShortestFirst) {
  const auto all = all_of(made_nist);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].wavelength, 5.32e-7);
  EXPECT_EQ(all[1].wavelength, 1.064e-6);
  EXPECT_EQ(all[0].samples.size(), 2U);
}

TEST(NistTable, HasItsTransmitterOnTheOtherSide) {
  const auto all = all_of(made_nist);
  EXPECT_EQ(all[0].samples[0].phi, pi);
  EXPECT_EQ(all[0].samples[0].f_r, 0.33);
  EXPECT_NEAR(all[0].samples[1].phi, 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(all[1].samples[0].theta_i, 0.001 * degree);
  EXPECT_DOUBLE_EQ(all[1].samples[0].phi, pi / 2);
}

TEST(FactorTable, IsDividedByPi) {
  const auto all = all_of(made_factors);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].wavelength, 3.8565e-7);
  EXPECT_DOUBLE_EQ(all[0].samples[1].f_r, 1.05 / pi);
  EXPECT_EQ(all[0].samples[1].phi, pi);
  EXPECT_THAT(all[0].notes, Contains("value: reflectance factor (BRF), divided by pi (the file says so)"));
}

TEST(FactorTable, ShowsSpectralonNearlyWhiteInTheInfrared) {
  const auto all = read_brdf_measurements(data_file("spectralon7_brf_vnir_386-1059nm.txt"));
  ASSERT_EQ(all.size(), 11U);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](auto& a, auto& b) { return a.wavelength < b.wavelength; }));
  EXPECT_EQ(all.back().wavelength, 1.05904e-6);
  ASSERT_EQ(all.back().samples.size(), 19U);
  EXPECT_DOUBLE_EQ(all.back().samples[0].f_r, 1.020632 / pi);
  EXPECT_TRUE(all.back().warnings.empty());
}

TEST(BadTable, IsWrong) {
  EXPECT_EQ(complaint_about("# phi_i theta_i phi_o theta_o brdf\n10 0 10 180 x\n"),
            "a.txt:2:13: expected a finite number, found 'x'");
  EXPECT_EQ(complaint_about("# phi_i theta_i phi_o theta_o brdf\n10 180 10 0\n"),
            "a.txt:2:12: expected 5 cells as in the header, found 4");
  EXPECT_EQ(complaint_about("# phi_i theta_i phi_o theta_o brdf\n180 10 10 0 1\n"),
            "a.txt:2:1: expected an angle from the normal of at most 90 deg, found 180");
  EXPECT_EQ(complaint_about("lambda,thetai,phi,thetar,phir,f_r11\n532,1,0,1,0,1\n2000,1,0,1,0,1\n"),
            "a.txt:3:1: expected a wavelength in um, up to 1000, found 2000");
  EXPECT_EQ(complaint_about("lambda,thetai,phi,thetar,phir,f_r11\n"),
            "a.txt: holds no values, expected at least one row of them");
  EXPECT_EQ(complaint_about("src_z src_a view_z view_a\n"),
            "a.txt:1:26: expected columns headed by wavelengths, such as 1064nm, found none");
  EXPECT_EQ(complaint_about("src_z src_a view_z view_a red\n"),
            "a.txt:1:27: expected a wavelength such as 1064nm as a column's name, found 'red'");
  EXPECT_EQ(complaint_about("src_z src_a view_z view_a 532nm 532nm\n"),
            "a.txt:1:33: a second column '532nm', expected one");
}

}  // namespace
}  // namespace lrcs
