#include "lrcs/scene_target.h"

#include <gtest/gtest.h>

#include "base/digest.h"
#include "tests/lrcs/test_targets.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

using By = AssignRule::By;
using Indices = std::vector<std::uint32_t>;

// Four facets: panel 1, panel 2, body, nose; of file materials Gold, Silver, Gold, Tin.
FacetMesh four_parts() {
  FacetMesh mesh;
  for (int k = 0; k < 4; ++k) add_triangle(mesh, {k + 0.0, 0, 0}, {k + 1.0, 0, 0}, {k + 0.0, 1, 0});
  mesh.part.of = {0, 1, 2, 3};
  mesh.part.names = {"panel 1", "panel 2", "body", "nose"};
  mesh.file_material.of = {0, 1, 0, 2};
  mesh.file_material.names = {"Gold", "Silver", "Tin"};
  return mesh;
}

Scene scene_of(std::vector<AssignRule> rules) {
  Scene scene;
  for (const char* name : {"a", "b", "c"}) scene.materials.push_back({name, Lambert(0.5), 0.0, ""});
  scene.assign = std::move(rules);
  scene.assign_place = {"scene.yaml", 9, 3};
  return scene;
}

AssignRule rule(By by, const std::string& pattern, const std::string& material) {
  return {by, pattern, material, {"scene.yaml", 10, 5}};
}

std::string complaint_about(std::vector<AssignRule> rules) {
  try {
    (void)assign_materials(four_parts(), scene_of(std::move(rules)));
    return "";
  } catch (const InputError& wrong) {
    return wrong.what();
  }
}

Indices fronts(const FacetMesh& mesh, std::vector<AssignRule> rules) {
  const FacetMaterials assigned = assign_materials(mesh, scene_of(std::move(rules)));
  EXPECT_TRUE(assigned.back.empty());
  return assigned.front;
}

TEST(AssignMaterials, GivesEveryFacetTheFirstRuleThatMatches) {
  EXPECT_EQ(fronts(four_parts(),
                   {rule(By::part, "panel 2", "b"), rule(By::part, "panel*", "c"), rule(By::everything, "", "a")}),
            (Indices{2, 1, 0, 0}));
  EXPECT_EQ(fronts(four_parts(),
                   {rule(By::part, "panel*", "c"), rule(By::part, "panel 2", "b"), rule(By::everything, "", "a")}),
            (Indices{2, 2, 0, 0}));
  EXPECT_EQ(fronts(four_parts(), {rule(By::everything, "", "a"), rule(By::part, "nose", "b")}), (Indices{0, 0, 0, 0}));
}

TEST(AssignMaterials, TakesShellPatterns) {
  const auto matched = [](const std::string& pattern) {
    return fronts(four_parts(), {rule(By::part, pattern, "b"), rule(By::everything, "", "a")});
  };
  EXPECT_EQ(matched("*"), (Indices{1, 1, 1, 1}));
  EXPECT_EQ(matched("panel ?"), (Indices{1, 1, 0, 0}));
  EXPECT_EQ(matched("panel [13-9]"), (Indices{1, 0, 0, 0}));
  EXPECT_EQ(matched("[!p]*"), (Indices{0, 0, 1, 1}));
  EXPECT_EQ(matched("body"), (Indices{0, 0, 1, 0}));
}

TEST(AssignMaterials, GoesByTheMaterialsOfTheFileToo) {
  EXPECT_EQ(fronts(four_parts(), {rule(By::part, "body", "c"), rule(By::file_material, "Gold", "a"),
                                  rule(By::file_material, "[ST]i*", "b")}),
            (Indices{0, 1, 2, 1}));
}

TEST(AssignMaterials, GoesByColoursAndLayersToo) {
  FacetMesh mesh = four_parts();
  mesh.colour = {{0, 1, 1, 0}, {"#c0c0c0", "#00ff7f"}};
  mesh.layer = {{0, 0, 1, 0}, {"", "paint"}};
  EXPECT_EQ(
      fronts(mesh, {rule(By::layer, "paint", "c"), rule(By::colour, "#00FF7F", "b"), rule(By::everything, "", "a")}),
      (Indices{0, 1, 2, 0}));
}

TEST(AssignMaterials, GoesByAPropertyOfFacets) {
  FacetMesh mesh = four_parts();
  mesh.properties = {{"coating", {{1, 0, 1, 2}, {"3", "17", "4"}}}};
  AssignRule by_coating = rule(By::property, "1?", "b");
  by_coating.property = "coating";
  EXPECT_EQ(fronts(mesh, {by_coating, rule(By::everything, "", "a")}), (Indices{1, 0, 1, 0}));
  const auto complaint = [&](const AssignRule& wrong) {
    try {
      (void)assign_materials(mesh, scene_of({wrong, rule(By::everything, "", "a")}));
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  by_coating.pattern = "5";
  EXPECT_EQ(complaint(by_coating),
            "scene.yaml:10:5: pattern '5' matches no value of coating of the target (values: '3', '17', '4')");
  by_coating.property = "coatin";
  EXPECT_EQ(complaint(by_coating),
            "scene.yaml:10:5: the target has no facet property 'coatin', did you mean 'coating'? (properties: "
            "'coating')");
}

TEST(AssignMaterials, GivesBacksTheirOwnWhereARuleSaysSo) {
  const auto assigned = [](const std::string& back_of_panels, const std::string& back_of_all) {
    AssignRule panels = rule(By::part, "panel*", "c"), all = rule(By::everything, "", "a");
    panels.back = back_of_panels;
    all.back = back_of_all;
    return assign_materials(four_parts(), scene_of({panels, all}));
  };
  EXPECT_EQ(assigned("b", "").front, (Indices{2, 2, 0, 0}));
  EXPECT_EQ(assigned("b", "").back, (Indices{1, 1, 0, 0}));
  EXPECT_EQ(assigned("", "b").back, (Indices{2, 2, 1, 1}));
  EXPECT_EQ(assigned("c", "a").back, Indices{});
}

TEST(AssignMaterials, SaysWhereAFileHasNoColours) {
  EXPECT_EQ(complaint_about({rule(By::colour, "#ff0000", "a"), rule(By::everything, "", "a")}),
            "scene.yaml:10:5: pattern '#ff0000' matches no colour of the target (the file has no colours)");
}

TEST(AssignMaterials, RefusesAPatternThatMatchesNothing) {
  EXPECT_EQ(complaint_about({rule(By::part, "panle 1", "a"), rule(By::everything, "", "a")}),
            "scene.yaml:10:5: pattern 'panle 1' matches no part of the target, did you mean 'panel 1'? (parts: 'panel "
            "1', 'panel 2', 'body', 'nose')");
  EXPECT_EQ(complaint_about({rule(By::file_material, "Lead", "a"), rule(By::everything, "", "a")}),
            "scene.yaml:10:5: pattern 'Lead' matches no material of the target (materials in the file: 'Gold', "
            "'Silver', 'Tin')");
}

TEST(AssignMaterials, RefusesToLeaveAFacetOut) {
  EXPECT_EQ(complaint_about({rule(By::part, "panel*", "a"), rule(By::part, "body", "a")}),
            "scene.yaml:9:3: 1 of 4 facets have no material, the first in part 'nose', file material 'Tin': expected "
            "a rule for each, or a last rule {default: MATERIAL}");
  EXPECT_NE(complaint_about({}), "");
}

TEST(LoadTarget, PlacesRepairsAndAssigns) {
  const ScratchFolder folder;
  // A triangle in the file's yz-plane, twice, and a third facet without area.
  folder.write("t.off", "OFF\n3 3 0\n0 0 0\n0 1000 0\n0 0 2000\n3 0 1 2\n3 0 1 2\n3 0 1 1\n");
  Scene scene = scene_of({rule(By::everything, "", "b")});
  scene.target.file = folder.path() / "t.off";
  scene.target.unit = "mm";
  scene.target.forward = "+y";
  const LoadedTarget repaired = load_target(scene);
  EXPECT_EQ(repaired.target.mesh.size(), 1U);
  EXPECT_EQ(repaired.repaired.duplicate, 1U);
  EXPECT_EQ(repaired.repaired.degenerate, 1U);
  EXPECT_EQ(repaired.target.material, Indices{1});
  EXPECT_DOUBLE_EQ(repaired.target.mesh.areas[0], 1.0);
  EXPECT_EQ(repaired.target.mesh.metres_per_unit * repaired.target.mesh.positions[1], Vec3(1.0, 0.0, 0.0));
  scene.target.repair = false;
  EXPECT_EQ(load_target(scene).target.mesh.size(), 3U);
  EXPECT_EQ(load_target(scene).repaired.degenerate, 0U);
}

TEST(LoadTarget, AssignsByATableOfFacetProperties) {
  const ScratchFolder folder;
  folder.write("t.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n3 0 1 2\n3 0 2 3\n");
  folder.write("zones.csv", "facet,zone\n1,hot\n");
  AssignRule hot = rule(By::property, "hot", "b");
  hot.property = "zone";
  Scene scene = scene_of({hot, rule(By::everything, "", "a")});
  scene.target.file = folder.path() / "t.off";
  scene.target.unit = "m";
  scene.target.facet_properties = folder.path() / "zones.csv";
  const LoadedTarget loaded = load_target(scene);
  EXPECT_EQ(loaded.target.material, (Indices{0, 1}));
  EXPECT_EQ(loaded.properties_digest, digest_of("facet,zone\n1,hot\n"));
  scene.target.facet_properties.clear();
  EXPECT_THROW((void)load_target(scene), InputError);
}

TEST(LoadTarget, TakesCadSurfacesAsCurvedUnlessToldNotTo) {
  Scene scene = read_scene(std::filesystem::path(LRCS_EXAMPLES) / "as1" / "scene.yaml");
  const LoadedTarget curved = load_target(scene);
  EXPECT_GT(curved.target.curved.facets().size(), 1000U);
  EXPECT_LT(curved.target.curved.facets().size(), curved.target.mesh.size());
  scene.target.tessellation.curving.by = Curving::By::nothing;
  const LoadedTarget flat = load_target(scene);
  EXPECT_TRUE(flat.target.curved.empty());
  EXPECT_EQ(flat.target.mesh.facets, curved.target.mesh.facets);
}

}  // namespace
}  // namespace lrcs
