#include <gtest/gtest.h>

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Parabola.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Parab.hxx>
#include <gp_Sphere.hxx>
#include <random>

#include "base/direction.h"
#include "brdf/library.h"
#include "cad/read_target.h"
#include "lrcs/convexity.h"
#include "lrcs/sweep.h"
#include "mesh/body_frame.h"
#include "mesh/repair.h"
#include "tests/cad/curved_reference.h"
#include "tests/cad/made_cad.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

constexpr double m = 1000.0;  // [mm]
constexpr std::size_t most_facets = 20000;

// Written as STEP, read as a user's file is.
Target target_of(const TopoDS_Shape& shape, double angle_deg, bool curved = true) {
  const ScratchFolder folder;
  const auto file = folder.path() / "body.step";
  MadeCad cad;
  cad.product(shape, "body");
  cad.write_step(file);
  Target target;
  target.mesh = read_target(file, "", {.relative = 0.01, .absolute = {}, .angle_deg = angle_deg}).mesh;
  if (!curved) target.mesh.curved = {};
  repair(target.mesh);
  place_in_body_frame(target.mesh, target.mesh.metres_per_unit, "+x", "+z");
  target.curved = CurvedSurface(target.mesh);
  target.material.assign(target.mesh.size(), 0);
  return target;
}

std::vector<std::pair<std::string, Brdf>> materials() {
  std::vector<std::pair<std::string, Brdf>> all{{"Lambert", Lambert(1.0)},
                                                {"narrow lobe", Steinvall(1.0, 0.0, 0.1, 0.0)}};
  for (const char* name : {"metal-skin-5p", "metal-skin-9p", "painted-steel-5p", "painted-steel-9p"})
    all.emplace_back(name, find_in_library(name)->brdf);
  return all;
}

Estimate sigma_of(Target& target, const Brdf& brdf, const Aspect& from) {
  target.materials = {{"m", brdf, 0.0, ""}};
  return run_sweep(target, {from}, 1)[0].sigma;
}

struct Solid {
  std::string name;
  TopoDS_Shape shape;
  RoundSurface surface;
  double angle_deg;
  double error;  // relative, at most
  std::vector<Aspect> aspects;
};

// z = r^2 / 2, r up to 1 m.
TopoDS_Shape paraboloid() {
  const gp_Parab curve(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0), gp_Dir(0, 0, 1)), 0.5 * m);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(Handle(Geom_Parabola)(new Geom_Parabola(curve)), 0.0, m);
  return BRepPrimAPI_MakeRevol(edge, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
}

std::vector<Solid> solids() {
  const std::vector<Aspect> all_round{aspect_between({0, 90}, {0, 90}),     aspect_between({20, 35}, {20, 35}),
                                      aspect_between({77, -12}, {77, -12}), aspect_between({200, 3}, {200, 3}),
                                      aspect_between({20, 35}, {60, 21}),   aspect_between({130, -40}, {75, 5}),
                                      aspect_between({-77, 50}, {10, 80})};
  const std::vector<Aspect> from_above{aspect_between({0, 90}, {0, 90}), aspect_between({40, 75}, {40, 75}),
                                       aspect_between({10, 62}, {10, 62}), aspect_between({40, 80}, {70, 65})};
  const std::vector<Aspect> from_below{aspect_between({0, -90}, {0, -90}), aspect_between({20, -60}, {20, -60}),
                                       aspect_between({40, -80}, {70, -50})};
  const double pi = std::numbers::pi;
  return {{"sphere", BRepPrimAPI_MakeSphere(m), ellipsoid_surface(1, 1, 1), 3.7, 1e-6, all_round},
          {"cylinder",
           BRepPrimAPI_MakeCylinder(m, m),
           {0, 1, [](double) { return Vec3(1, 1, 0); }, {{Vec3(0, 0, 1), pi}, {Vec3(0, 0, -1), pi}}},
           3.0,
           1e-6,
           all_round},
          {"cone",
           BRepPrimAPI_MakeCone(m, 0, 3 * m),
           {0, 1, [](double v) { return Vec3((1 - v) * Vec3(3, 3, 1)); }, {{Vec3(0, 0, -1), pi}}},
           3.0,
           1e-6,
           all_round},
          {"torus", BRepPrimAPI_MakeTorus(m, 0.4 * m), torus_surface(1, 0.4), 7.3, 1e-6, from_above},
          {"ellipsoid", ellipsoid_of(m, 1, 0.7, 0.5), ellipsoid_surface(1, 0.7, 0.5), 2.4, 1e-6, all_round},
          {"paraboloid",
           paraboloid(),
           {0, 1, [](double v) { return Vec3(v * Vec3(v, v, -1)); }, {}},
           1.9,
           1e-6,
           from_below}};
}

TEST(CurvedSections, SigmaOfUnshadedSolidsIsRightToMillionths) {
  for (const Solid& solid : solids()) {
    Target target = target_of(solid.shape, solid.angle_deg);
    EXPECT_LE(target.mesh.size(), most_facets) << solid.name;
    for (const auto& [name, brdf] : materials())
      for (const Aspect& from : solid.aspects) {
        // All with all takes a minute; these are what materials differ in.
        if (solid.name != "sphere" && solid.name != "cone" && name != "narrow lobe" && name != "metal-skin-5p")
          continue;
        const double exact = unshaded_sigma(solid.surface, brdf, from.to_transmitter, from.to_receiver);
        const Estimate sigma = sigma_of(target, brdf, from);
        const auto where = testing::Message() << solid.name << ", " << target.mesh.size() << " facets, " << name << ", "
                                              << from.transmitter.azimuth_deg << " " << from.transmitter.elevation_deg;
        const double of_reference = 3e-8 * exact;
        EXPECT_NEAR(sigma.value, exact, solid.error * exact + of_reference) << where;
        EXPECT_NEAR(sigma.value, exact, sigma.bound + of_reference) << where;
      }
  }
}

// Also cones, whose facets lie askew to its rulings and bend forward between them.
TEST(CurvedSections, OfConvexSolidsCountAsConvexBodies) {
  for (const Solid& solid : solids()) {
    if (solid.name == "ellipsoid" || solid.name == "paraboloid") continue;
    const FacetMesh mesh = target_of(solid.shape, solid.angle_deg).mesh;
    EXPECT_EQ(is_convex_body(mesh), solid.name != "torus") << solid.name;
  }
}

// From wherever chance has it: creases of the models and the transmitter's terminator lie differently each time.
TEST(CurvedSections, SigmaFromRandomPairsOfDirectionsIsRightToMillionths) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const Solid& solid : solids()) {
    if (solid.name == "torus" || solid.name == "paraboloid") continue;  // shade themselves from some
    Target target = target_of(solid.shape, solid.angle_deg);
    for (const auto& [name, brdf] : materials())
      for (int k = 0; k < 6; ++k) {
        const double azimuth = 180.0 * unit(random), elevation = std::asin(unit(random)) / degree;
        const AspectAngles transmitter{azimuth, elevation};
        const AspectAngles receiver{azimuth + 40.0 * unit(random),
                                    std::clamp(elevation + 20.0 * unit(random), -89.0, 89.0)};
        const Aspect from = aspect_between(transmitter, receiver);
        const double exact = unshaded_sigma(solid.surface, brdf, from.to_transmitter, from.to_receiver);
        const Estimate sigma = sigma_of(target, brdf, from);
        const auto where = testing::Message() << solid.name << ", " << name << ", " << azimuth << " " << elevation
                                              << " to " << receiver.azimuth_deg << " " << receiver.elevation_deg;
        EXPECT_NEAR(sigma.value, exact, solid.error * exact) << where;
        EXPECT_NEAR(sigma.value, exact, sigma.bound + 3e-8 * exact) << where;
      }
  }
}

TEST(CurvedSections, SigmaOfAShadedTorusIsRightToAHundredThousandth) {
  constexpr double wanted = 1e-5;
  // A lobe through which the shadow's edge runs is a few facets wide; just over the plane of the ring its far side
  // shows over the near one by less than chords rise.
  constexpr double missed_in_lobe = 3e-5, missed_near_plane = 4e-5;
  struct View {
    AspectAngles from;
    double error_of_lobe = wanted, error_of_broad = wanted;
  };
  const std::vector<View> views{{{10, 45}},
                                {{20, 35}},
                                {{100, 25}},
                                {{70, 20}},
                                {{33, 15}},
                                {{5, 12}},
                                {{0, 11}, missed_in_lobe},
                                {{71, 12.2}, missed_in_lobe},
                                {{80, 9}},
                                {{0, 7}},
                                {{14, 7}},
                                {{37, 3}},
                                {{20, 1}},
                                {{0, 0}},
                                {{50, 0}},
                                {{70, 0}},
                                {{45, 0.0025}, wanted, missed_near_plane},
                                {{63, 0.1}},
                                {{7, 0.5}}};
  const ShadedTorus torus(1.0, 0.4);
  Target target = target_of(BRepPrimAPI_MakeTorus(m, 0.4 * m), 7.3);
  EXPECT_LE(target.mesh.size(), most_facets);
  for (const auto& [name, brdf] : materials())
    for (const auto& [from, error_of_lobe, error_of_broad] : views) {
      const double exact = torus.sigma(brdf, direction_of(from));
      const Estimate sigma = sigma_of(target, brdf, aspect_between(from, from));
      const double error = name == "narrow lobe" ? error_of_lobe : error_of_broad;
      EXPECT_NEAR(sigma.value, exact, error * exact) << name << ", elevation " << from.elevation_deg;
      EXPECT_NEAR(sigma.value, exact, sigma.bound) << name << ", elevation " << from.elevation_deg;
    }
}

TEST(CurvedSections, ABallHidesOfAPlateBehindItWhatItsTrueOutlineDoes) {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 5 * m), m).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(-2 * m, -2 * m, -m), gp_Pnt(2 * m, 2 * m, 0)).Shape());
  const double exact = 8.0 / 3.0 * std::numbers::pi + 4.0 * (16.0 - std::numbers::pi);
  for (const bool curved : {true, false}) {
    Target target = target_of(both, 8.0, curved);
    const Estimate sigma = sigma_of(target, Lambert(1.0), aspect_between({0, 90}, {0, 90}));
    if (curved) {
      EXPECT_NEAR(sigma.value, exact, 3e-7 * exact);
      EXPECT_NEAR(sigma.value, exact, sigma.bound);
    } else {
      EXPECT_GT(std::abs(sigma.value - exact), 1e-5 * exact);
    }
  }
}

TEST(CurvedSections, APlateHidesOfABallBehindItAllThatLiesBesideItsEdge) {
  constexpr double edge = 0.3;
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeSphere(m).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(-9 * m, -9 * m, 2 * m), gp_Pnt(edge * m, 9 * m, 2.5 * m)).Shape());
  Target target = target_of(both, 3.7);
  EXPECT_LE(target.mesh.size(), most_facets);
  for (const auto& [transmitter, receiver] : std::vector<std::pair<double, double>>{
           {90.0, 90.0}, {64.0, 64.0}, {40.0, 40.0}, {90.0, 64.0}, {40.0, 64.0}, {40.0, 90.0}}) {
    // Lambert: 4 times the integral of cos_i cos_r; over a slice of the ball across the edge, in which both directions
    // lie, that is r^2 / 2 [(pi - b) cos b + sin b]. And the plate's faces: two lie across the view.
    const double b = std::abs(transmitter - receiver) * degree;
    const double ball = 2.0 * ((std::numbers::pi - b) * std::cos(b) + std::sin(b)) *
                        ((1.0 - 1.0 / 3.0) - (edge - edge * edge * edge / 3.0));
    const double up = std::sin(transmitter * degree) * std::sin(receiver * degree);
    const double out = std::cos(transmitter * degree) * std::cos(receiver * degree);
    const double plate = 4.0 * (9.0 + edge) * (18.0 * up + 0.5 * out);
    const Estimate sigma = sigma_of(target, Lambert(1.0), aspect_between({90, transmitter}, {90, receiver}));
    const double error = transmitter == receiver ? 1e-6 : 3e-6;
    EXPECT_NEAR(sigma.value - plate, ball, error * ball) << transmitter << ", " << receiver;
    EXPECT_NEAR(sigma.value - plate, ball, sigma.bound) << transmitter << ", " << receiver;
  }
}

// An edge along either axis of the plate's facets.
TEST(CurvedSections, ACylinderBeforeAPlateMayLieAlongEitherAxis) {
  const double exact = 64.0 - 16.0 + 4.0 * std::numbers::pi;
  for (const gp_Dir& axis : {gp_Dir(1, 0, 0), gp_Dir(0, 1, 0)}) {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    const gp_Pnt start(-m * axis.X(), -m * axis.Y(), 5 * m);
    builder.Add(both, BRepPrimAPI_MakeCylinder(gp_Ax2(start, axis), m, 2 * m).Shape());
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(-2 * m, -2 * m, -m), gp_Pnt(2 * m, 2 * m, 0)).Shape());
    Target target = target_of(both, 8.0);
    EXPECT_NEAR(sigma_of(target, Lambert(1.0), aspect_between({0, 90}, {0, 90})).value, exact, 3e-7 * exact);
  }
}

TEST(CurvedSections, ReferencesAgreeWhereTheTorusDoesNotShadeItself) {
  const Vec3 w = direction_of({40, 75});
  EXPECT_NEAR(ShadedTorus(1.0, 0.4).sigma(Lambert(1.0), w), unshaded_sigma(torus_surface(1, 0.4), Lambert(1.0), w, w),
              1e-7);
  EXPECT_NEAR(unshaded_sigma(ellipsoid_surface(2, 2, 2), Lambert(0.5), w, w), 8.0 / 3.0 * std::numbers::pi * 2.0, 1e-8);
}

TEST(CurvedSections, ConvergesAtFourthOrderAndFlatFacetsAtSecond) {
  const RoundSurface surface = torus_surface(1, 0.4);
  const Brdf brdf = find_in_library("metal-skin-5p")->brdf;
  for (const bool curved : {true, false}) {
    std::vector<double> errors, facets;
    for (const double angle : {36.0, 18.0, 9.0}) {
      Target target = target_of(BRepPrimAPI_MakeTorus(m, 0.4 * m), angle, curved);
      double worst = 0.0;
      for (const AspectAngles& from : {AspectAngles{20, 80}, AspectAngles{77, 65}, AspectAngles{-50, 70}}) {
        const Aspect at = aspect_between(from, from);
        const double exact = unshaded_sigma(surface, brdf, at.to_transmitter, at.to_receiver);
        worst = std::max(worst, std::abs(sigma_of(target, brdf, at).value / exact - 1.0));
      }
      errors.push_back(worst);
      facets.push_back(static_cast<double>(target.mesh.size()));
    }
    // By the length of an edge, which goes as one over the root of the number of facets.
    const double order = -2.0 * std::log(errors[2] / errors[0]) / std::log(facets[2] / facets[0]);
    if (curved)
      EXPECT_GE(order, 4.0);
    else
      EXPECT_NEAR(order, 2.0, 0.5);
  }
}

// Half a sphere, dome and bowl: from straight above and below each returns what the whole sphere would.
TEST(CurvedSections, OfASheetReturnFromEachSideWhatItsMaterialDoes) {
  const gp_Sphere ball(gp_Ax3(), m);
  Target target =
      target_of(BRepBuilderAPI_MakeFace(ball, 0.0, 2.0 * std::numbers::pi, 0.0, 0.5 * std::numbers::pi).Shape(), 3.7);
  ASSERT_FALSE(target.curved.empty());
  constexpr double front = 0.8, back = 0.3;
  target.materials = {{"front", Lambert(front), 0.0, ""}, {"back", Lambert(back), 0.0, ""}};
  target.back.assign(target.mesh.size(), 1);
  for (const double side : {1.0, -1.0}) {
    const double expected = 8.0 / 3.0 * std::numbers::pi * (side > 0.0 ? front : back);
    const Aspect from = aspect_between({0, 90.0 * side}, {0, 90.0 * side});
    EXPECT_NEAR(run_sweep(target, {from}, 1)[0].sigma.value, expected, 3e-6 * expected);
  }
}

}  // namespace
}  // namespace lrcs
