#include "mesh/diagnosis.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_meshes.h"
#include "mesh/info_text.h"

namespace lrcs {
namespace {

FacetMesh hollow_box() {
  return joined(box({0, 0, 0}, {3, 3, 3}), reversed(box({1, 1, 1}, {2, 2, 2})));
}

TEST(Diagnosis, MeasuresABox) {
  const Diagnosis d = diagnose(box({1, 2, 3}, {2, 4, 6}));
  EXPECT_EQ(d.facets, 12U);
  EXPECT_EQ(d.vertices, 8U);
  EXPECT_DOUBLE_EQ(d.area, 22.0);
  EXPECT_DOUBLE_EQ(d.volume, 6.0);
  EXPECT_EQ(d.box[0], Vec3(1, 2, 3));
  EXPECT_EQ(d.box[1], Vec3(2, 4, 6));
  EXPECT_TRUE(d.closed);
  EXPECT_EQ(
      d.degenerate + d.duplicate + d.non_manifold_edges + d.boundary_edges + d.flipped + d.self_intersections.pairs,
      0U);
  ASSERT_EQ(d.parts.size(), 1U);
  EXPECT_TRUE(d.parts[0].closed);
  EXPECT_DOUBLE_EQ(*d.parts[0].volume, 6.0);
}

TEST(Diagnosis, TakesACavityOffTheVolume) {
  const Diagnosis d = diagnose(hollow_box());
  EXPECT_NEAR(d.volume, 26.0, 1e-13);
  EXPECT_EQ(d.flipped, 0U);
  EXPECT_TRUE(d.closed);
}

TEST(Diagnosis, GivesTheVolumeOfAnInwardBoxAsPositiveAndCountsItsFacetsAsFlipped) {
  const Diagnosis d = diagnose(reversed(unit_box()));
  EXPECT_DOUBLE_EQ(d.volume, 1.0);
  EXPECT_EQ(d.flipped, 12U);
}

TEST(Diagnosis, MeasuresTwoBoxesOfOnePartThatLieFaceToFace) {
  const FacetMesh stack = joined(unit_box(), box({0, 0, 1}, {1, 1, 2}));
  for (const FacetMesh& mesh : {stack, reversed(stack)}) {
    const Diagnosis d = diagnose(mesh);
    EXPECT_DOUBLE_EQ(d.volume, 2.0);
    EXPECT_TRUE(d.parts[0].closed);
    EXPECT_EQ(d.non_manifold_edges, 5U);  // round the common side, and its diagonal
    EXPECT_EQ(d.flipped, mesh.normals[0] == stack.normals[0] ? 0U : 24U);
  }
}

TEST(Diagnosis, SaysOfTwoBoxesOfOnePartThatFaceDifferentWaysThatTheyAreNotManifold) {
  const Diagnosis d = diagnose(joined(unit_box(), reversed(box({0, 0, 1}, {1, 1, 2}))));
  EXPECT_EQ(d.non_manifold_edges, 4U);
  EXPECT_EQ(d.duplicate, 2U);
  EXPECT_EQ(d.flipped, 0U);
  EXPECT_FALSE(d.parts[0].closed);
}

TEST(Diagnosis, CountsTheBoundaryOfAnOpenBox) {
  FacetMesh open = unit_box();
  open.facets.resize(10);
  const Diagnosis d = diagnose(mesh_of(open.positions, open.facets));
  EXPECT_FALSE(d.closed);
  EXPECT_EQ(d.boundary_edges, 4U);
  EXPECT_EQ(d.volume, 0.0);
  EXPECT_FALSE(d.parts[0].volume.has_value());
}

TEST(Diagnosis, SaysOfAMoebiusBandThatItIsOpenAndNotFlipped) {
  const Diagnosis d = diagnose(moebius(20));
  EXPECT_FALSE(d.closed);
  EXPECT_EQ(d.boundary_edges, 40U);
  EXPECT_EQ(d.non_manifold_edges, 0U);
  EXPECT_EQ(d.flipped, 0U);
}

TEST(Diagnosis, CountsTheEdgeOfThreeFins) {
  const Diagnosis d =
      diagnose(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(d.non_manifold_edges, 1U);
  EXPECT_EQ(d.boundary_edges, 6U);
  EXPECT_FALSE(d.closed);
}

TEST(Diagnosis, FindsTwoBoxesThatTouchFaceToFaceClosedPartByPart) {
  const Diagnosis d = diagnose(joined(unit_box(), box({1, 0, 0}, {2, 1, 1}), true));
  EXPECT_TRUE(d.closed);
  EXPECT_EQ(d.non_manifold_edges, 4U + 1U);  // around the common side, and its diagonal
  EXPECT_EQ(d.vertices, 12U);
  EXPECT_NEAR(d.volume, 2.0, 1e-14);
  ASSERT_EQ(d.parts.size(), 2U);
  EXPECT_TRUE(d.parts[0].closed && d.parts[1].closed);
}

TEST(Diagnosis, CountsDegenerateAndDuplicateFacets) {
  const Diagnosis d = diagnose(
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {1, 2, 4}, {0, 1, 3}, {0, 4, 1}}));
  EXPECT_EQ(d.facets, 4U);
  EXPECT_EQ(d.degenerate, 2U);
  EXPECT_EQ(d.duplicate, 1U);
  EXPECT_EQ(d.vertices, 4U);
}

TEST(Diagnosis, ManagesASingleFacetAndAFileOfDegenerateOnes) {
  const Diagnosis single = diagnose(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  EXPECT_EQ(single.boundary_edges, 3U);
  EXPECT_EQ(single.area, 0.5);
  const Diagnosis none = diagnose(mesh_of({{0, 0, 0}, {1, 1, 1}}, {{0, 1, 1}, {0, 0, 0}}));
  EXPECT_EQ(none.degenerate, 2U);
  EXPECT_FALSE(none.closed);
  EXPECT_FALSE(none.parts[0].closed);
  EXPECT_EQ(none.area, 0.0);
}

TEST(Diagnosis, IsTheSameForAnyOrderOfTheFacets) {
  FacetMesh mesh = joined(joined(hollow_box(), reversed(box({5, 5, 5}, {6, 6, 6}))), moebius(14));
  const Diagnosis before = diagnose(mesh);
  std::reverse(mesh.facets.begin(), mesh.facets.end());
  const Diagnosis after = diagnose(mesh);
  EXPECT_EQ(after.flipped, before.flipped);
  EXPECT_EQ(after.boundary_edges, before.boundary_edges);
  EXPECT_NEAR(after.volume, before.volume, 1e-13);
}

TEST(InfoJson, HasTheKeysOfTheInterface) {
  FacetMesh mesh = unit_box();
  mesh.part.names = {"hull"};
  mesh.file_material.names = {"paint"};
  const auto json = nlohmann::ordered_json::parse(info_json(diagnose(mesh), {"", "mm", "", {}}));
  EXPECT_EQ(
      json.dump(),
      R"({"facets":12,"vertices":8,"area_m2":6.0,"volume_m3":1.0,"box_m":[[0.0,0.0,0.0],[1.0,1.0,1.0]],"closed":true,)"
      R"("unit":"mm","diagnosis":{"degenerate":0,"duplicate":0,"opposite_duplicate":0,"non_manifold_edges":0,)"
      R"("boundary_edges":0,"holes":0,"t_junctions":0,"flipped":0,"inward_shells":0,"against_most":0,"near_vertices":0,)"
      R"("gaps_complete":true,"normals_against_winding":0,"self_intersections":0,"self_intersections_complete":true,)"
      R"("parts_that_meet":[]},"parts":[{"name":"hull","facets":12,"area_m2":6.0,"volume_m3":1.0,"closed":true,)"
      R"("material":"paint","colour":null}]})");
}

TEST(InfoJson, HasNullForWhatIsNotKnown) {
  FacetMesh open = unit_box();
  open.facets.resize(10);
  const auto json = nlohmann::json::parse(info_json(diagnose(mesh_of(open.positions, open.facets)), {}));
  EXPECT_TRUE(json["unit"].is_null());
  EXPECT_TRUE(json["area_m2"].is_null());
  EXPECT_TRUE(json["box_m"].is_null());
  EXPECT_TRUE(json["parts"][0]["volume_m3"].is_null());
  EXPECT_TRUE(json["parts"][0]["material"].is_null());
}

TEST(InfoJson, ReplacesWhatIsNotUtf8InAName) {
  FacetMesh mesh = unit_box();
  mesh.part.names = {"Fl\xfcgel"};
  EXPECT_EQ(nlohmann::json::parse(info_json(diagnose(mesh), {"", "m", "", {}}))["parts"][0]["name"],
            "Fl\xef\xbf\xbdgel");
}

TEST(Diagnosis, TellsWhatIsWrongWithWhichPart) {
  FacetMesh mesh = joined(
      reversed(unit_box()),
      mesh_of({{4, 0, 0}, {5, 0, 0}, {4, 1, 0}, {5, 1, 0}}, {{0, 1, 2}, {1, 2, 3}, {0, 2, 1}, {0, 1, 2}, {0, 1, 1}}),
      true);
  const Diagnosis d = diagnose(mesh);
  EXPECT_EQ(d.parts[0].flipped, 12U);
  EXPECT_EQ(d.parts[0].inward_shells, 1U);
  EXPECT_EQ(d.parts[0].boundary_edges + d.parts[0].holes + d.parts[0].opposite, 0U);
  EXPECT_EQ(d.parts[1].duplicate, 1U);
  EXPECT_EQ(d.parts[1].degenerate, 1U);
  EXPECT_EQ(d.parts[1].opposite, 1U);
  EXPECT_EQ(d.parts[1].flipped, 0U);
  EXPECT_EQ(d.opposite, 1U);
  EXPECT_EQ(d.inward_shells, 1U);
}

TEST(Diagnosis, CountsFacetsAgainstMostOfAnOpenPiece) {
  const Diagnosis d =
      diagnose(mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 3, 2}, {1, 4, 2}}));
  EXPECT_EQ(d.against_most, 1U);
  EXPECT_EQ(d.parts[0].against_most, 1U);
}

TEST(Diagnosis, NamesThePartsThatPassThroughEachOther) {
  FacetMesh mesh = joined(unit_box(), box({0.5, 0.25, 0.25}, {1.5, 0.75, 0.75}), true);
  mesh.part.names = {"hull", "boom"};
  const Diagnosis d = diagnose(mesh);
  ASSERT_EQ(d.meeting.size(), 1U);
  EXPECT_EQ(d.meeting[0].one + " " + d.meeting[0].other, "hull boom");
  EXPECT_EQ(d.meeting[0].facet_pairs, d.self_intersections.pairs);
  EXPECT_NE(info_text(d, {"a.stl", "m", "", {}}).find("parts that meet       hull and boom: "), std::string::npos);
}

TEST(Diagnosis, TellsOfGapsOfAMillionthOfTheTarget) {
  FacetMesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, -1e-7, 0}, {0.5, -1e-7, 0}, {1, -1e-7, 0}, {1, -1, 0}},
                           {{0, 1, 2}, {4, 3, 6}, {4, 6, 5}});
  const Diagnosis d = diagnose(mesh);
  EXPECT_EQ(d.near_vertices, 2U);
  EXPECT_EQ(d.t_junctions, 1U);
  EXPECT_EQ(d.holes, 2U);
  EXPECT_NE(info_text(d, {"a.stl", "m", "", {}}).find("2 pairs of vertices, 1 T-junctions"), std::string::npos);
}

TEST(InfoText, SaysWhereTheCountOfSelfIntersectionsStopped) {
  Diagnosis d = diagnose(unit_box());
  d.self_intersections.pairs = 5;
  d.self_intersections.complete = false;
  EXPECT_NE(info_text(d, {"box.stl", "mm", "", {}}).find("at least 5 pairs of facets (counting stopped)\n"),
            std::string::npos);
  const auto json = nlohmann::json::parse(info_json(d, {"", "mm", "", {}}));
  EXPECT_EQ(json["diagnosis"]["self_intersections"], 5);
  EXPECT_EQ(json["diagnosis"]["self_intersections_complete"], false);
}

TEST(InfoText, NamesAHundredColoursAtMost) {
  FacetMesh mesh = mesh_of({}, {});
  for (int k = 0; k < 102; ++k) {
    mesh = joined(mesh, mesh_of({{3.0 * k, 0, 0}, {3.0 * k + 1, 0, 0}, {3.0 * k, 1, 0}}, {{0, 1, 2}}));
    mesh.colour.of.push_back(static_cast<std::uint32_t>(k));
    mesh.colour.names.push_back(fmt::format("#0000{:02x}", k));
  }
  const std::string text = info_text(diagnose(mesh), {"scan.ply", "mm", "", {}});
  EXPECT_NE(text.find("\"#000063\""), std::string::npos);
  EXPECT_EQ(text.find("\"#000064\""), std::string::npos);
  EXPECT_NE(text.find("  # and 2 more\n  - {default: MATERIAL}\n"), std::string::npos);
}

TEST(InfoText, TellsAPersonWhatWasRead) {
  FacetMesh mesh = joined(unit_box(), mesh_of({{4, 0, 0}, {5, 0, 0}, {4, 1, 0}}, {{0, 1, 2}}), true);
  mesh.part.names = {"h\xc3\xbclle", "sail"};
  EXPECT_EQ(info_text(diagnose(mesh), {"box.stl", "mm", "", {}}),
            "box.stl\n"
            "unit                  mm\n"
            "parts                 2\n"
            "facets                13\n"
            "vertices              11\n"
            "area                  6.5 m^2\n"
            "volume                1 m^3 (closed shells)\n"
            "box                   5 x 1 x 1 m, (0, 0, 0) to (5, 1, 1)\n"
            "closed                no\n"
            "degenerate            0 facets\n"
            "duplicate             0 facets, and 0 in the opposite winding\n"
            "non-manifold          0 edges\n"
            "boundary              3 edges round 1 holes or sheets\n"
            "flipped               0 facets of closed shells (0 shells face inward), 0 of open pieces\n"
            "self-intersecting     0 pairs of facets\n"
            "\n"
            "part      facets      area [m^2]    volume [m^3]  closed  material\n"
            "h\xc3\xbclle         12               6               1  yes     -\n"
            "sail           1             0.5               -  no      -\n"
            "\n"
            "what is wrong with parts\n"
            "sail: 3 boundary edges, 1 holes\n"
            "\n"
            "assign:  # for a scene file\n"
            "  - {part: \"h\xc3\xbclle\", material: MATERIAL}  # 1 part, area 6\n"
            "  - {part: \"sail\", material: MATERIAL}  # 1 part, area 0.5\n"
            "  - {default: MATERIAL}\n");
}

}  // namespace
}  // namespace lrcs
