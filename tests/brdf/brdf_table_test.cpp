#include "brdf/brdf_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

using testing::HasSubstr;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(BrdfTable, IsAMeasurementFileOfTheMaterial) {
  const Material& material = *find_in_library("metal-skin-5p");
  const auto lines = lines_of(brdf_table(material, {0.0, 30.0}, 20.0));
  EXPECT_THAT(lines, testing::IsSupersetOf({std::string("# wavelength: 1.06 um"),
                                            std::string("# azimuth_of_specular: 180"), std::string("# value: brdf")}));
  const auto columns = std::find(lines.begin(), lines.end(), "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr,G");
  ASSERT_NE(columns, lines.end());
  EXPECT_EQ(lines.end() - columns - 1, 2 * 9);
  EXPECT_EQ(*(columns + 5), "0,0,0,0.168,1");
}

TEST(BrdfTable, CountsANegativeThetaRAsTheSpecularSide) {
  const Material& material = *find_in_library("metal-skin-9p");
  const auto lines = lines_of(brdf_table(material, {30.0}, 40.0));
  const double across = f_r_angles(material.brdf, 30 * degree, 40 * degree, std::numbers::pi);
  const auto row = std::find_if(lines.begin(), lines.end(), [](const auto& l) { return l.starts_with("30,-40,0,"); });
  ASSERT_NE(row, lines.end());
  EXPECT_NEAR(std::stod(row->substr(9)), across, 1e-14);
}

TEST(BrdfTable, WarnsWhereWuPassesOneAndIsNotReciprocal) {
  const auto warnings = brdf_warnings(find_in_library("metal-skin-5p")->brdf);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_THAT(warnings[0], HasSubstr("the albedo passes 1 from theta_i = 81 deg on"));
  EXPECT_THAT(warnings[1], HasSubstr("not reciprocal: f_r changes by up to 83 %"));
}

TEST(BrdfTable, SaysBetweenWhichAnglesTheAlbedoPassesOne) {
  // B (cos_i cos_r)^(m/2) has the albedo 2 pi B cos_i^(m/2) / (2 + m/2): 5.73 at 0 deg, 1 at 20.6 deg.
  const auto warnings = brdf_warnings(Steinvall(0.0, 26.0, 0.1, 53.0));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0], "the albedo passes 1 between theta_i = 0 and 20 deg (5.73 at 0 deg)");
}

TEST(BrdfTable, DoesNotTakeRoundingForALackOfReciprocity) {
  const Wu without_diffuse({0.1, 0.3, -5.0, 1.0, 0.0});
  EXPECT_THAT(brdf_warnings(without_diffuse), testing::Each(testing::Not(HasSubstr("not reciprocal"))));
}

TEST(BrdfTable, HasNothingToWarnOfForLambert) {
  EXPECT_THAT(brdf_warnings(Lambert(1.0)), testing::IsEmpty());
  EXPECT_THAT(brdf_table({"white", Lambert(1.0), 0.0, ""}, {0.0}), testing::Not(HasSubstr("wavelength")));
}

TEST(BrdfTable, RefusesAnglesOutsideTheirDomain) {
  const Material white{"white", Lambert(1.0), 0.0, ""};
  EXPECT_THROW(static_cast<void>(brdf_table(white, {90.0})), std::domain_error);
  EXPECT_THROW(static_cast<void>(brdf_table(white, {-1.0})), std::domain_error);
  EXPECT_THROW(static_cast<void>(brdf_table(white, {})), std::domain_error);
  EXPECT_THROW(static_cast<void>(brdf_table(white, {0.0}, 0.0)), std::domain_error);
  EXPECT_THROW(static_cast<void>(brdf_table(white, {0.0}, 1e-9)), std::domain_error);
  EXPECT_THROW(static_cast<void>(brdf_table(white, {0.0}, 10.0, 90.0)), std::domain_error);
}

TEST(MaterialsTable, NamesEveryMaterialWithModelWavelengthParametersAndSource) {
  const std::string table = materials_table();
  for (const Material& material : material_library()) {
    EXPECT_THAT(table, HasSubstr(material.name));
    EXPECT_THAT(table, HasSubstr(description_of(material.brdf)));
    EXPECT_THAT(table, HasSubstr(material.source));
  }
  EXPECT_THAT(table, HasSubstr("1.06 um"));
}

}  // namespace
}  // namespace lrcs
