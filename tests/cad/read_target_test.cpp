#include "cad/read_target.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "base/input_error.h"
#include "mesh/diagnosis.h"
#include "mesh/repair.h"
#include "tests/cad/made_cad.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

using testing::ElementsAre;

// A body, and two wings that are one product, one of them coloured; each wing has a bolt.
MadeCad satellite() {
  MadeCad cad;
  const TDF_Label all = cad.assembly("satellite"), wing = cad.assembly("wing");
  const TDF_Label body = cad.product(box_of(20.0, 20.0, 30.0), "body"),
                  plate = cad.product(box_of(40.0, 1.0, 20.0), "plate"),
                  bolt = cad.product(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape(), "bolt");
  cad.place(wing, plate, {});
  cad.place(wing, bolt, moved_by(5.0, 5.0, 1.0));
  cad.place(all, body, {});
  cad.colour(cad.place(all, wing, moved_by(30.0, 0.0, 0.0)), "#0000ff");
  cad.place(all, wing, moved_by(-60.0, 0.0, 0.0));
  cad.colour(body, "#ff0000");
  cad.colour_face(body, 2, "#00ff00");
  return cad;
}

TargetRead read(const ScratchFolder& folder, MadeCad cad, const char* unit = "MM", const char* schema = "AP214IS") {
  cad.write_step(folder.path() / "made.step", unit, schema);
  return read_target(folder.path() / "made.step");
}

TEST(ReadTarget, NamesEachInstanceByItsPath) {
  const ScratchFolder folder;
  for (const char* schema : {"AP203", "AP214IS", "AP242DIS"}) {
    const TargetRead target = read(folder, satellite(), "MM", schema);
    EXPECT_THAT(target.mesh.part.names, ElementsAre("satellite/body", "satellite/wing:1/plate", "satellite/wing:1/bolt",
                                                    "satellite/wing:2/plate", "satellite/wing:2/bolt"))
        << schema;
    EXPECT_EQ(target.unit, "mm");
    EXPECT_TRUE(target.warnings.empty());
  }
}

TEST(ReadTarget, PlacesEachInstance) {
  const ScratchFolder folder;
  const TargetRead target = read(folder, satellite());
  Diagnosis d = diagnose(target.mesh);
  EXPECT_TRUE(d.closed);
  EXPECT_EQ(d.flipped, 0U);
  EXPECT_EQ(d.self_intersections.pairs, 0U);
  EXPECT_NEAR(d.volume, 1e-9 * (20 * 20 * 30 + 2 * 40 * 1 * 20 + 2 * std::numbers::pi * 4 * 5), 0.005 * 1e-9 * 13700);
  EXPECT_NEAR(d.box[0].x(), -0.060, 1e-12);
  EXPECT_NEAR(d.box[1].x(), 0.070, 1e-12);
}

TEST(ReadTarget, TakesTheColourOfTheFaceElseOfWhatItIsPartOf) {
  const ScratchFolder folder;
  const Diagnosis d = diagnose(read(folder, satellite()).mesh);
  EXPECT_EQ(d.parts[0].colour, "#00ff00, #ff0000");
  for (std::size_t k = 1; k < 5; ++k) EXPECT_EQ(d.parts[k].colour, k < 3 ? "#0000ff" : "") << d.parts[k].name;
}

TEST(ReadTarget, TakesAColourOfOneInstance) {
  MadeCad cad;
  const TDF_Label all = cad.assembly("all"), box = cad.product(box_of(1.0, 1.0, 1.0), "box");
  cad.place(all, box, {});
  cad.colour(cad.place(all, box, moved_by(3.0, 0.0, 0.0)), "#808000");
  cad.colour(box, "#102030");
  const ScratchFolder folder;
  const Diagnosis d = diagnose(read(folder, cad).mesh);
  ASSERT_EQ(d.parts.size(), 2U);
  EXPECT_EQ(d.parts[0].colour, "#102030");
  EXPECT_EQ(d.parts[1].colour, "#808000");
}

TEST(ReadTarget, KeepsLayers) {
  MadeCad cad;
  cad.layer(cad.product(box_of(1.0, 1.0, 1.0), "box"), "structure");
  const ScratchFolder folder;
  EXPECT_EQ(diagnose(read(folder, cad).mesh).parts.at(0).layer, "structure");
}

TEST(ReadTarget, ReadsTheUnitOfTheFile) {
  const ScratchFolder folder;
  for (const auto& [step, name] : {std::pair{"MM", "mm"}, {"M", "m"}, {"INCH", "inch"}, {"FT", "ft"}, {"CM", "cm"}}) {
    const TargetRead target = read(folder, satellite(), step);
    EXPECT_EQ(target.unit, name);
    EXPECT_NEAR(diagnose(target.mesh).box[1].x(), 0.070, 1e-12) << step;
  }
}

TEST(ReadTarget, LetsTheUserSayAnotherUnit) {
  const ScratchFolder folder;
  satellite().write_step(folder.path() / "made.step", "INCH");
  const TargetRead target = read_target(folder.path() / "made.step", "m");
  EXPECT_EQ(target.unit, "m");
  EXPECT_NEAR(diagnose(target.mesh).box[1].x(), 70.0 / 25.4, 1e-9);
}

TEST(ReadTarget, TurnsFacesOutwardOfMirroredSolids) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  MadeCad cad;
  const TopoDS_Shape box = box_of(1.0, 2.0, 3.0);
  cad.product(BRepBuilderAPI_Transform(box, mirror, true).Shape(), "mirrored");
  cad.product(box.Reversed(), "inside out");
  const ScratchFolder folder;
  const TargetRead target = read(folder, cad);
  EXPECT_EQ(target.mesh.part.names.size(), 2U);
  EXPECT_NEAR(diagnose(target.mesh).volume, 12e-9, 1e-20);
  FacetMesh mesh = target.mesh;
  EXPECT_EQ(repair(mesh).flipped, 0U);
}

TEST(ReadTarget, TurnsFacesOutwardInAMirroredPlace) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(5, 0, 0), gp_Dir(1, 0, 0)));
  const ScratchFolder folder;
  write_brep(box_of(1.0, 2.0, 3.0).Located(TopLoc_Location(mirror), false), folder.path() / "mirrored.brep");
  const Diagnosis d = diagnose(read_target(folder.path() / "mirrored.brep", "m").mesh);
  EXPECT_EQ(d.flipped, 0U);
  EXPECT_NEAR(d.volume, 6.0, 1e-12);
  EXPECT_NEAR(d.box[0].x(), 9.0, 1e-12);
}

TEST(ReadTarget, KeepsPartsApartWhoseNamesLookNumbered) {
  MadeCad cad;
  const TDF_Label all = cad.assembly("all");
  for (const char* name : {"a", "a", "a:1"}) cad.place(all, cad.product(box_of(1.0, 1.0, 1.0), name), {});
  const ScratchFolder folder;
  EXPECT_THAT(read(folder, cad).mesh.part.names, ElementsAre("all/a:2", "all/a:3", "all/a:1"));
}

// A solid without its shell, whatever it was.
TEST(ReadTarget, WarnsOfWhatIsMissing) {
  const ScratchFolder folder;
  satellite().write_step(folder.path() / "whole.step");
  std::string text = folder.read("whole.step");
  const std::size_t begin = text.find("CLOSED_SHELL(");
  const std::size_t line = text.rfind('\n', begin) + 1;
  text.erase(line, text.find(';', begin) + 2 - line);
  folder.write("part.step", text);
  const TargetRead target = read_target(folder.path() / "part.step");
  EXPECT_LT(target.mesh.part.names.size(), 5U);
  EXPECT_FALSE(target.warnings.empty());
}

TEST(ReadTarget, RefusesAnotherUnitWhereTheFilesIsNotKnown) {
  const ScratchFolder folder;
  satellite().write_step(folder.path() / "made.step", "INCH");
  std::string text = folder.read("made.step");
  for (std::size_t at = text.find("'INCH'"); at != std::string::npos; at = text.find("'INCH'", at + 1))
    text.replace(at, 6, "'ELL'");
  folder.write("made.step", text);
  EXPECT_NEAR(diagnose(read_target(folder.path() / "made.step").mesh).box[1].x(), 0.070, 1e-12);
  EXPECT_THROW((void)read_target(folder.path() / "made.step", "mm"), InputError);
}

TEST(ReadTarget, ReadsBrepInTheUsersUnit) {
  const ScratchFolder folder;
  write_brep(BRepPrimAPI_MakeSphere(1.0).Shape(), folder.path() / "ball.brep");
  EXPECT_EQ(read_target(folder.path() / "ball.brep").unit, "");
  const TargetRead target = read_target(folder.path() / "ball.brep", "m");
  const Diagnosis d = diagnose(target.mesh);
  EXPECT_TRUE(d.closed);
  EXPECT_NEAR(d.volume, 4.0 / 3.0 * std::numbers::pi, 0.01 * 4.2);
}

TEST(ReadTarget, JoinsTheFacesOfIges) {
  const ScratchFolder folder;
  for (const auto& [iges, name] : {std::pair{"MM", "mm"}, {"IN", "inch"}}) {
    write_iges(BRepPrimAPI_MakeCylinder(5.0, 20.0).Shape(), folder.path() / "made.igs", iges);
    const TargetRead target = read_target(folder.path() / "made.igs");
    EXPECT_EQ(target.unit, name);
    const Diagnosis d = diagnose(target.mesh);
    EXPECT_TRUE(d.closed);
    EXPECT_EQ(d.boundary_edges, 0U);
    EXPECT_NEAR(d.volume, std::numbers::pi * 500e-9, 0.005 * 1571e-9);
  }
}

TEST(ReadTarget, MakesFacetsAsFineAsAsked) {
  const ScratchFolder folder;
  write_brep(BRepPrimAPI_MakeSphere(1.0).Shape(), folder.path() / "ball.brep");
  Tessellation fine;
  fine.absolute = 1e-3;
  fine.angle_deg = 90.0;
  double largest = 0.0;
  const TargetRead ball = read_target(folder.path() / "ball.brep", "m", fine);
  for (std::size_t k = 0; k < ball.mesh.size(); ++k) {
    const auto [a, b, c] = ball.mesh.corners(k);
    for (const Vec3& p : {a, b, c}) EXPECT_NEAR(p.norm(), 1.0, 1e-12);
    largest = std::max(largest, 1.0 - ((a + b + c) / 3.0).norm());
  }
  EXPECT_LE(largest, 2e-3);  // Open CASCADE keeps the tolerance on edges, and roughly inside
  EXPECT_GE(largest, 1e-4);
}

TEST(ReadTarget, ReadsMeshesToo) {
  const ScratchFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const TargetRead target = read_target(folder.path() / "a.obj");
  EXPECT_EQ(target.mesh.size(), 1U);
  EXPECT_EQ(target.unit, "");
  EXPECT_EQ(target.tessellation, "");
}

TEST(ReadTarget, DoubtsTheUnitOfGrainsAndMountains) {
  const ScratchFolder folder;
  folder.write("a.off", "OFF\n3 1 0\n0 0 0\n3000 0 0\n0 4000 0\n3 0 1 2\n");
  for (const char* unit : {"mm", "cm", "inch"})
    EXPECT_TRUE(read_target(folder.path() / "a.off", unit).warnings.empty());
  EXPECT_TRUE(read_target(folder.path() / "a.off").warnings.empty());
  EXPECT_THAT(
      read_target(folder.path() / "a.off", "m").warnings,
      ElementsAre("the target is 5e+03 m across in m: is that its unit? It would be 5 m in mm, 50 m in cm, 127 m "
                  "in inch"));
  EXPECT_EQ(read_target(folder.path() / "a.off", "nm").warnings.size(), 1U);
}

TEST(BadCad, IsAnInputErrorWhateverBytesAreChangedOrCutOff) {
  const ScratchFolder folder;
  satellite().write_step(folder.path() / "good.step");
  write_brep(BRepPrimAPI_MakeCylinder(5.0, 20.0).Shape(), folder.path() / "good.brep");
  write_iges(BRepPrimAPI_MakeCylinder(5.0, 20.0).Shape(), folder.path() / "good.igs", "MM");
  std::mt19937_64 random(5);
  int refused = 0;
  for (const char* name : {"good.step", "good.brep", "good.igs"}) {
    const std::string good = folder.read(name);
    for (int k = 0; k < 24; ++k) {
      std::string bytes = good.substr(0, k % 4 == 0 ? random() % good.size() : good.size());
      for (std::size_t flips = 1 + random() % 6; flips > 0 && !bytes.empty(); --flips)
        bytes[random() % bytes.size()] = static_cast<char>(32 + random() % 95);
      folder.write("bad", bytes);
      try {
        const TargetRead target = read_target(folder.path() / "bad");
        EXPECT_GT(target.mesh.size(), 0U);
        for (const Vec3& p : target.mesh.positions) EXPECT_TRUE(p.allFinite());
      } catch (const InputError& error) {
        EXPECT_NE(std::string_view(error.what()).find("bad"), std::string_view::npos);
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 6);
}

}  // namespace
}  // namespace lrcs
