#include "lrcs/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/digest.h"
#include "lrcs/sweep_yaml.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

// The scene of docs/scene.md.
const std::string documented = R"(lrcs: 1                         # format version, required
wavelength: 1.06 um             # a material made for another wavelength is a warning that names both; unit required
target:
  file: motor.stl               # relative to this file
  unit: mm                      # required where the format has none (STL, OBJ, PLY, OFF, VTP); an override elsewhere
  forward: +x                   # which file axis is the nose (default +x) and which is up (default +z)
  up: +z
  sides: both                   # a facet reflects from whichever side is seen; front: from its outward side only
  repair: auto                  # weld, drop degenerate and duplicate facets, orient closed parts outward; none: as given
  curved: auto                  # of CAD surfaces: integrated over the true surface; none: over its flat facets
  chord_tolerance: 1e-3         # of CAD surfaces: how far facets may lie off them, of a part's size, or a length (0.1 mm)
  chord_angle: 8                # the same: how far they may turn from edge to edge [deg]
  facet_properties: zones.csv   # more that facets can be told apart by: facet,NAME[,NAME...]
materials:
  skin:  {library: metal-skin-5p}
  paint: {model: five_parameter, kb: 0.153, kr: 0.456, b: -26.998, a: 0.667, kd: 0.015, azimuth_of_specular: 180}
  white: {model: lambert, reflectance: 0.8}
assign:                         # first match wins; a pattern that matches nothing, or a facet with no material, is an error
  - {part: "panel*", material: paint}
  - {default: skin}
sweep:
  azimuth: {from: 0, to: 350, step: 10}     # deg; also a number or a list
  elevation: 0                              # or, instead of both: directions: [[17, 31], [200, -35]]
receiver: monostatic            # or {azimuth: A, elevation: E}: fixed in the body frame; or {bistatic_angle: B, plane: azimuth | elevation}
accuracy: exact                 # or {relative: 1e-3}: the program then takes the cheapest way that meets it
output:
  facets: [{azimuth: 0, elevation: 0}]      # directions for which per-facet VTP files are written; or all, or none
)";

const std::string shortest =
    "lrcs: 1\ntarget: {file: a.stl, unit: m}\nmaterials: {w: {model: lambert, reflectance: 1}}\n"
    "assign: [{default: w}]\n";

class SceneFile : public testing::Test {
 protected:
  Scene read(const std::string& text) const {
    folder_.write("scene.yaml", text);
    return read_scene(folder_.path() / "scene.yaml");
  }
  ScratchFolder folder_;
};

TEST_F(SceneFile, OfTheManualIsAcceptedAsItStands) {
  const Scene scene = read(documented);
  EXPECT_EQ(scene.wavelength, 1.06e-6);
  EXPECT_EQ(scene.target.file, folder_.path() / "motor.stl");
  EXPECT_EQ(scene.target.unit, "mm");
  EXPECT_EQ(scene.target.tessellation.relative, 1e-3);
  EXPECT_EQ(scene.target.tessellation.absolute, std::nullopt);
  EXPECT_EQ(scene.target.tessellation.angle_deg, 8.0);
  EXPECT_EQ(scene.target.facet_properties, folder_.path() / "zones.csv");
  EXPECT_EQ(scene.target.forward, "+x");
  EXPECT_EQ(scene.target.up, "+z");
  EXPECT_EQ(scene.target.sides, Sides::both);
  EXPECT_TRUE(scene.target.repair);
  EXPECT_EQ(scene.target.tessellation.curving.by, Curving::By::cad_surfaces);
  ASSERT_EQ(scene.materials.size(), 3U);
  EXPECT_EQ(scene.materials[0].name, "skin");
  EXPECT_EQ(scene.materials[0].wavelength, 1.06e-6);
  EXPECT_EQ(scene.materials[2].name, "white");
  ASSERT_EQ(scene.assign.size(), 2U);
  EXPECT_EQ(scene.assign[0].pattern, "panel*");
  EXPECT_EQ(scene.assign[0].material, "paint");
  EXPECT_EQ(scene.assign[1].by, AssignRule::By::everything);
  ASSERT_EQ(scene.directions.size(), 36U);
  EXPECT_EQ(scene.directions.front(), (AspectAngles{0.0, 0.0}));
  EXPECT_EQ(scene.directions.back(), (AspectAngles{350.0, 0.0}));
  EXPECT_EQ(scene.receiver.kind, Receiver::Kind::monostatic);
  EXPECT_FALSE(scene.relative_accuracy.has_value());
  EXPECT_EQ(facet_rows(scene), std::vector<std::size_t>{0});
  EXPECT_EQ(scene.digest, digest_of(documented));
}

TEST_F(SceneFile, HasTheDocumentedDefaults) {
  const Scene scene = read(shortest + "sweep: {azimuth: 7}\n");
  EXPECT_EQ(scene.wavelength, 0.0);
  EXPECT_EQ(scene.target.forward, "+x");
  EXPECT_EQ(scene.target.up, "+z");
  EXPECT_EQ(scene.target.sides, Sides::both);
  EXPECT_TRUE(scene.target.repair);
  EXPECT_EQ(scene.directions, (std::vector<AspectAngles>{{7.0, 0.0}}));
  EXPECT_EQ(scene.receiver.kind, Receiver::Kind::monostatic);
  EXPECT_FALSE(scene.relative_accuracy.has_value());
  EXPECT_FALSE(scene.facets.all);
  EXPECT_TRUE(facet_rows(scene).empty());
}

TEST_F(SceneFile, TakesDirectionsAsRangesListsNumbersAndPairs) {
  const auto directions = [&](const std::string& sweep) {
    return read(shortest + "sweep: " + sweep + "\n").directions;
  };
  using Pairs = std::vector<AspectAngles>;
  EXPECT_EQ(directions("{azimuth: [10, 0], elevation: [-5, 5]}"), (Pairs{{10, -5}, {0, -5}, {10, 5}, {0, 5}}));
  EXPECT_EQ(directions("{azimuth: {from: 1, to: -1, step: -1}, elevation: 90}"), (Pairs{{1, 90}, {0, 90}, {-1, 90}}));
  EXPECT_EQ(directions("{directions: [[17, 31], [200, -35]]}"), (Pairs{{17, 31}, {200, -35}}));
}

TEST_F(SceneFile, TakesEveryReceiver) {
  const auto receiver = [&](const std::string& words) {
    return read(shortest + "sweep: {azimuth: 0}\nreceiver: " + words + "\n").receiver;
  };
  EXPECT_EQ(receiver("monostatic").kind, Receiver::Kind::monostatic);
  EXPECT_EQ(receiver("{azimuth: 40, elevation: 20}").kind, Receiver::Kind::fixed);
  EXPECT_EQ(receiver("{azimuth: 40, elevation: 20}").fixed, (AspectAngles{40.0, 20.0}));
  EXPECT_EQ(receiver("{bistatic_angle: 30}").plane, Receiver::Plane::azimuth);
  EXPECT_EQ(receiver("{bistatic_angle: -30, plane: elevation}").plane, Receiver::Plane::elevation);
  EXPECT_EQ(receiver("{bistatic_angle: -30, plane: elevation}").bistatic_angle_deg, -30.0);
}

TEST_F(SceneFile, TakesAnAccuracyAndFacets) {
  const Scene scene = read(shortest + "sweep: {azimuth: 0}\naccuracy: {relative: 1e-3}\noutput: {facets: all}\n");
  EXPECT_EQ(scene.relative_accuracy, 1e-3);
  EXPECT_TRUE(scene.facets.all);
  EXPECT_FALSE(read(shortest + "sweep: {azimuth: 0}\noutput: {facets: none}\n").facets.all);
}

TEST_F(SceneFile, TakesAMaterialOfBacksUnlessNoneIsSeen) {
  const auto with_back = [](const std::string& sides) {
    return "lrcs: 1\ntarget: {file: a.stl, unit: m, sides: " + sides +
           "}\nmaterials: {w: {model: lambert, reflectance: 1}, b: {model: lambert, reflectance: 0, wavelength: 532 "
           "nm}}\nassign: [{part: wing, material: w, back: b}, {default: w, back: w}, {default: w}]\n"
           "wavelength: 1.06 um\nsweep: {azimuth: 0}\n";
  };
  const Scene scene = read(with_back("both"));
  EXPECT_EQ(scene.assign[0].back, "b");
  EXPECT_EQ(scene.assign[1].back, "w");
  EXPECT_EQ(scene.assign[2].back, "");
  EXPECT_THAT(wavelength_warnings(scene),
              testing::ElementsAre("material 'b' is for 0.532 um, the scene is at 1.06 um"));
  try {
    (void)read(with_back("front"));
    FAIL() << "taken";
  } catch (const InputError& wrong) {
    EXPECT_THAT(wrong.what(), testing::HasSubstr("scene.yaml:4:36: with 'sides: front' no back is seen"));
  }
}

TEST_F(SceneFile, WarnsOnlyOfMaterialsForAnotherWavelength) {
  const std::string sweep = "sweep: {azimuth: 0}\n";
  EXPECT_THAT(wavelength_warnings(read(shortest + sweep + "wavelength: 1.55 um\n")), testing::IsEmpty());
  std::string text = shortest + sweep + "wavelength: 1.55 um\n";
  const std::string other = "{model: lambert, reflectance: 1, wavelength: 532 nm}";
  text.replace(text.find("{model: lambert, reflectance: 1}"), 32, other);
  EXPECT_THAT(wavelength_warnings(read(text)),
              testing::ElementsAre("material 'w' is for 0.532 um, the scene is at 1.55 um"));
  text.replace(text.find("1.55 um"), 7, "0.532um");
  EXPECT_THAT(wavelength_warnings(read(text)), testing::IsEmpty());
}

TEST_F(SceneFile, FindsTheRowOfEveryFacetDirection) {
  const std::string fine = "sweep: {azimuth: {from: 0, to: 360, step: 0.1}, elevation: [0, 90]}\n";
  const auto rows = [&](const std::string& facets) {
    return facet_rows(read(shortest + fine + "output: {facets: " + facets + "}\n"));
  };
  // 0 + 3 * 0.1 is not the double nearest to 0.3.
  EXPECT_EQ(rows("[{azimuth: 0.3, elevation: 0}]"), (std::vector<std::size_t>{3}));
  EXPECT_EQ(rows("[{azimuth: 360, elevation: 0}, {azimuth: 0, elevation: 0}]"), (std::vector<std::size_t>{3600, 0}));
  EXPECT_EQ(rows("[{azimuth: -90, elevation: 0}]"), (std::vector<std::size_t>{2700}));
  // Straight up all azimuths point the same way, but only one is the row asked for.
  EXPECT_EQ(rows("[{azimuth: 2, elevation: 90}]"), (std::vector<std::size_t>{3621}));
  EXPECT_THROW(rows("[{azimuth: 0.05, elevation: 0}]"), InputError);
}

TEST(AngleRange, OfAWholeTurnInTenthsEndsExactly) {
  const auto angles = angle_range(0.0, 360.0, 0.1);
  ASSERT_EQ(angles.size(), 3601U);
  EXPECT_EQ(angles.front(), 0.0);
  EXPECT_EQ(angles.back(), 360.0);
  for (std::size_t k = 0; k < angles.size(); ++k) EXPECT_NEAR(angles[k], 0.1 * static_cast<double>(k), 1e-12);
}

TEST(AngleRange, OfTenthsHasTheDoublesOfItsDecimals) {
  EXPECT_EQ(angle_range(0.0, 0.5, 0.1), (std::vector<double>{0.0, 0.1, 0.2, 0.3, 0.4, 0.5}));
}

TEST(AngleRange, StopsBeforeWhatItDoesNotReach) {
  EXPECT_EQ(angle_range(0.0, 10.0, 4.0), (std::vector<double>{0.0, 4.0, 8.0}));
  EXPECT_EQ(angle_range(0.0, 10.0, 20.0), (std::vector<double>{0.0}));
  EXPECT_EQ(angle_range(5.0, 5.0, 1.0), (std::vector<double>{5.0}));
}

TEST(AngleRange, GoesDownwardWithANegativeStep) {
  EXPECT_EQ(angle_range(10.0, -10.0, -10.0), (std::vector<double>{10.0, 0.0, -10.0}));
  EXPECT_EQ(angle_range(1.0, 0.0, -0.1).size(), 11U);
  EXPECT_EQ(angle_range(1.0, 0.0, -0.1).back(), 0.0);
  EXPECT_TRUE(angle_range(0.0, 10.0, -1.0).empty());
  EXPECT_TRUE(angle_range(10.0, 0.0, 1.0).empty());
}

}  // namespace
}  // namespace lrcs
