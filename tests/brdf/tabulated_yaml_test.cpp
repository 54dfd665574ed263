#include "brdf/tabulated_yaml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "brdf/brdf_table.h"
#include "brdf/material_yaml.h"
#include "tests/brdf/sample_brdfs.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

using testing::HasSubstr;

const std::string csv = R"(# wavelength: 532 nm
# azimuth_of_specular: 180
# value: brdf
theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr
0,0,0,0.1
0,40,0,0.2
40,40,0,0.3
40,40,180,0.4
40,40,90,0.5
)";

class TabulatedYaml : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("retro.csv", csv);
    std::string unsaid = csv;
    folder.write("unsaid.csv", unsaid.erase(0, unsaid.find("# value")));
  }
  Material read(const std::string& yaml) const {
    folder.write("m.yaml", yaml);
    return material_from_words((folder.path() / "m.yaml").string());
  }
  // Without the folder's name.
  std::string complaint(const std::string& yaml) const {
    try {
      return "accepted " + read(yaml).name;
    } catch (const InputError& error) {
      std::string what = error.what();
      const std::string name = folder.path().string() + "/";
      for (std::size_t at = 0; (at = what.find(name)) != std::string::npos;) what.erase(at, name.size());
      return what;
    }
  }
  ScratchFolder folder;
};

TEST_F(TabulatedYaml, ReadsAFileBesideIt) {
  const Material tape = read("{model: tabulated, file: retro.csv, outside: nearest, source: lab}");
  const auto& table = std::get<Tabulated>(tape.brdf);
  EXPECT_EQ(tape.wavelength, 532e-9);
  EXPECT_EQ(tape.source, "lab");
  EXPECT_EQ(table.outside(), Outside::nearest);
  EXPECT_EQ(table.samples(), 5U);
  EXPECT_NEAR(f_r_angles(tape.brdf, 40 * degree, 40 * degree, std::numbers::pi), 0.4, 1e-12);
  EXPECT_EQ(description_of(tape.brdf), "tabulated file=retro.csv format=\"" + table.measurement().format +
                                           "\" samples=5 places=5 outside=nearest");
}

TEST_F(TabulatedYaml, ReadsBackWhatItWrites) {
  const Material tape = read("{model: tabulated, file: unsaid.csv, wavelength: 1.06 um, azimuth_of_specular: 0}");
  const std::string yaml = material_to_yaml(tape);
  EXPECT_THAT(yaml, testing::AllOf(HasSubstr("azimuth_of_specular: 0\n"), HasSubstr("outside: error\n"),
                                   HasSubstr("wavelength: 1.06 um\n")));
  const Material again = material_from_yaml(LocatedYaml::of_text(yaml, "again.yaml"), "tape");
  EXPECT_EQ(material_to_yaml(again), yaml);
  EXPECT_EQ(f_r_angles(again.brdf, 0.5, 0.5, 0.1), f_r_angles(tape.brdf, 0.5, 0.5, 0.1));
}

TEST_F(TabulatedYaml, TakesTheAzimuthOfSpecularWhereTheFileDoesNotSay) {
  const double pi = std::numbers::pi;
  const Material turned = read("{model: tabulated, file: unsaid.csv, azimuth_of_specular: 0}");
  EXPECT_NEAR(f_r_angles(turned.brdf, 40 * degree, 40 * degree, pi), 0.3, 1e-12);
  EXPECT_THAT(complaint("{model: tabulated, file: retro.csv, azimuth_of_specular: 0}"), HasSubstr("retro.csv"));
}

TEST_F(TabulatedYaml, ComparesTheWavelength) {
  EXPECT_EQ(read("{model: tabulated, file: retro.csv, wavelength: 532.3 nm}").wavelength, 532e-9);
  EXPECT_EQ(read("{model: tabulated, file: unsaid.csv, azimuth_of_specular: 180}").wavelength, 0.0);
  EXPECT_EQ(complaint("model: tabulated\nfile: retro.csv\nwavelength: 1.06 um"),
            "m.yaml:3:13: retro.csv holds no measurement at 1.06 um; it holds 0.532 um");
}

TEST_F(TabulatedYaml, PutsEveryMistakeAtItsPlace) {
  EXPECT_EQ(complaint("model: tabulated\nfile: retr.csv"), "m.yaml:2:7: no such file: retr.csv");
  EXPECT_EQ(complaint("{model: tabulated}"), "m.yaml:1:1: key 'file' is missing");
  EXPECT_THAT(complaint("model: tabulated\nfile: retro.csv\noutsid: zero"),
              testing::StartsWith("m.yaml:3:1: unknown key 'outsid', did you mean 'outside'?"));
  EXPECT_THAT(complaint("model: tabulated\nfile: retro.csv\noutside: nearby"),
              testing::StartsWith("m.yaml:3:10: expected "));
  EXPECT_THAT(complaint("model: tabulated\nfile: retro.csv\nazimuth_of_specular: 90"),
              testing::StartsWith("m.yaml:3:22: expected azimuth_of_specular 180 or 0"));
  EXPECT_THAT(complaint("model: lambert\nreflectance: 1\noutside: zero"), HasSubstr("it belongs to tabulated"));
}

TEST_F(TabulatedYaml, LeavesRowsOutOfTheTableThatWereNotMeasured) {
  const Material tape = read("{model: tabulated, file: retro.csv}");
  const std::string table = brdf_table(tape, {0.0, 40.0}, 20.0);
  EXPECT_THAT(table, HasSubstr("# not measured, left out: theta_i = 0 deg, theta_r = -80 -60 60 80 deg\n"));
  EXPECT_THAT(table, HasSubstr("# albedo at theta_i = 0 deg: at least "));
  EXPECT_THAT(table, HasSubstr("\n0,0,0,0.1"));
  EXPECT_THAT(table, testing::Not(HasSubstr("\n0,60,")));
  EXPECT_THAT(table, testing::Not(HasSubstr("nan")));
  EXPECT_THAT(brdf_warnings(tape.brdf), testing::Contains(HasSubstr("not all directions were measured")));
}

}  // namespace
}  // namespace lrcs
