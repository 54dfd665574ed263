#include "mesh/file_normals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "base/direction.h"
#include "brdf/library.h"
#include "lrcs/scene_target.h"
#include "lrcs/sweep.h"
#include "tests/cad/curved_reference.h"
#include "tests/cad/made_cad.h"
#include "tests/cad/normal_files.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

using testing::IsEmpty;
using By = Curving::By;

const std::vector<Aspect> all_round{aspect_between({20, 35}, {20, 35}), aspect_between({77, -12}, {77, -12}),
                                    aspect_between({200, 3}, {200, 3}), aspect_between({20, 35}, {60, 21}),
                                    aspect_between({130, -40}, {75, 5})};

// As a scene takes it, with +x forward and +z up.
class FileNormalsOf : public testing::Test {
 protected:
  [[nodiscard]] LoadedTarget load(const std::string& name, const Curving& curving) const {
    Scene scene;
    scene.materials = {*find_in_library("metal-skin-5p")};
    scene.assign = {{AssignRule::By::everything, "", scene.materials[0].name, {}}};
    scene.target.file = folder_.path() / name;
    scene.target.unit = "m";
    scene.target.tessellation.curving = curving;
    return load_target(scene);
  }
  [[nodiscard]] LoadedTarget load(const std::string& name, const std::string& content,
                                  const Curving& curving = {By::file_normals}) const {
    folder_.write(name, content);
    return load(name, curving);
  }
  [[nodiscard]] std::string complaint_about(const std::string& name) const {
    try {
      (void)load(name, {By::file_normals});
      return "none";
    } catch (const InputError& wrong) {
      return std::string(wrong.what()).substr(folder_.path().string().size() + 1);
    }
  }
  [[nodiscard]] std::string complaint_about(const std::string& name, const std::string& content) const {
    folder_.write(name, content);
    return complaint_about(name);
  }

  ScratchFolder folder_;
};

// Of the true surface, seen all round [m^2].
std::vector<double> sigma_of(const RoundSurface& surface) {
  std::vector<double> sigma;
  for (const Aspect& a : all_round)
    sigma.push_back(unshaded_sigma(surface, find_in_library("metal-skin-5p")->brdf, a.to_transmitter, a.to_receiver));
  return sigma;
}

// The largest relative one.
double error_of(const LoadedTarget& loaded, const std::vector<double>& exact) {
  double worst = 0.0;
  const auto rows = run_sweep(loaded.target, all_round, 1);
  for (std::size_t k = 0; k < rows.size(); ++k) worst = std::max(worst, std::abs(rows[k].sigma.value / exact[k] - 1.0));
  return worst;
}

TEST_F(FileNormalsOf, ASphereConvergeAtFourthOrderInEveryFormat) {
  const auto unit_sphere = sigma_of(ellipsoid_surface(1, 1, 1));
  std::map<std::string, std::array<double, 2>> errors;
  for (const std::size_t finer : {0U, 1U}) {
    const CornerMesh ball = ball_with_normals(2 + static_cast<int>(finer), 0.15);
    const VertexMesh own = unwelded(ball), shared{ball.mesh, ball.mesh.positions};
    for (const auto& [name, content] : {std::pair<std::string, std::string>{"a.obj", obj(ball)},
                                        {"a.ply", ply(own, "binary_little_endian")},
                                        {"shared.ply", ply(shared, "ascii")},
                                        {"a.off", noff(shared)},
                                        {"a.vtp", vtp(shared)},
                                        {"a.vtu", vtu(own)},
                                        {"a.gltf", gltf(own)}}) {
      const LoadedTarget loaded = load(name, content);
      EXPECT_THAT(loaded.warnings, IsEmpty()) << name;
      EXPECT_EQ(loaded.target.curved.facets().size(), loaded.target.mesh.size()) << name;
      errors[name][finer] = error_of(loaded, unit_sphere);
    }
  }
  for (const auto& [name, error] : errors) {
    EXPECT_LT(error[1], 1e-5) << name;
    EXPECT_GT(std::log2(error[0] / error[1]), 3.5) << name;
  }
}

TEST_F(FileNormalsOf, AnEllipsoidAreBetterThanEstimatedOnes) {
  const Vec3 axes(1.0, 0.7, 0.5);
  const auto exact = sigma_of(ellipsoid_surface(axes.x(), axes.y(), axes.z()));
  for (const int level : {2, 3}) {
    CornerMesh egg = ball_with_normals(level, 0.15);
    for (Vec3& p : egg.mesh.positions) p = p.cwiseProduct(axes);
    for (auto& corners : egg.normals)
      for (Vec3& n : corners) n = n.cwiseQuotient(axes);
    const double by_file = error_of(load("a.obj", obj(egg)), exact);
    const double by_crease = error_of(load("a.obj", {By::estimated_normals, 60.0}), exact);
    const double flat = error_of(load("a.obj", {By::nothing}), exact);
    EXPECT_LT(by_file, 0.2 * by_crease);
    EXPECT_LT(by_file, 0.01 * flat);
  }
}

TEST_F(FileNormalsOf, ACylinderKeepItsRimsSharp) {
  // The caps stay polygons.
  constexpr double cap = 24.0 * 0.13052619222005157;  // sides / 2 sin(2 pi / sides)
  const RoundSurface tube{0, 2, [](double) { return Vec3(1, 1, 0); }, {{Vec3(0, 0, 1), cap}, {Vec3(0, 0, -1), cap}}};
  const auto exact = sigma_of(tube);
  const CornerMesh made = cylinder_with_normals(48, 2.0);
  const VertexMesh own = unwelded(made);
  for (const auto& [name, content] : {std::pair<std::string, std::string>{"a.obj", obj(made)},
                                      {"a.ply", ply(own, "ascii")},
                                      {"a.vtp", vtp(own)},
                                      {"a.gltf", gltf(own)}}) {
    const LoadedTarget loaded = load(name, content);
    EXPECT_EQ(loaded.target.curved.facets().size(), 96U) << name;
    EXPECT_LT(error_of(loaded, exact), 4e-5) << name;
    EXPECT_GT(error_of(load(name, {By::nothing}), exact), 1e-2) << name;
  }
}

TEST_F(FileNormalsOf, EveryFormatGiveTheSameSigma) {
  for (CornerMesh made : {ball_with_normals(2, 0.1), cylinder_with_normals(16, 2.0)}) {
    round_to_floats(made);
    const VertexMesh own = unwelded(made);
    folder_.write("a.obj", obj(made));
    folder_.write("a.off", noff(own));
    folder_.write("a.ply", ply(own, "ascii"));
    folder_.write("little.ply", ply(own, "binary_little_endian"));
    folder_.write("big.ply", ply(own, "binary_big_endian"));
    folder_.write("a.vtp", vtp(own));
    folder_.write("named.vtp", vtp(own, "", "Normals"));
    folder_.write("declared.vtp", vtp(own, R"( Normals="n")", "n"));
    folder_.write("a.vtu", vtu(own));
    folder_.write("a.gltf", gltf(own));
    const auto expected = run_sweep(load("a.obj", {By::file_normals}).target, all_round, 1);
    for (const char* name :
         {"a.off", "a.ply", "little.ply", "big.ply", "a.vtp", "named.vtp", "declared.vtp", "a.vtu", "a.gltf"}) {
      const LoadedTarget loaded = load(name, {By::file_normals});
      EXPECT_THAT(loaded.warnings, IsEmpty()) << name;
      const auto rows = run_sweep(loaded.target, all_round, 1);
      for (std::size_t k = 0; k < rows.size(); ++k) {
        EXPECT_NEAR(rows[k].sigma.value / expected[k].sigma.value, 1.0, 1e-12) << name;
        EXPECT_NEAR(rows[k].sigma.bound / expected[k].sigma.bound, 1.0, 1e-9) << name;
      }
    }
  }
}

TEST_F(FileNormalsOf, GltfGoWithItsNodes) {
  const VertexMesh ball = unwelded(ball_with_normals(3, 0.0));
  const auto egg = sigma_of(ellipsoid_surface(1, 0.7, 0.5));
  for (const char* scale : {"1, 0.7, 0.5", "1, -0.7, 0.5", "-1, -0.7, -0.5"}) {
    const LoadedTarget loaded = load("a.gltf", gltf(ball, fmt::format(R"({{"mesh": 0, "scale": [{}]}})", scale)));
    EXPECT_THAT(loaded.warnings, IsEmpty()) << scale;
    EXPECT_LT(error_of(loaded, egg), 1e-4) << scale;
  }
  // Turned by 90 deg about z, after the scale: what was along x is along y.
  const LoadedTarget turned =
      load("a.gltf", gltf(ball, R"({"children": [1], "rotation": [0, 0, 0.70710678118654752, 0.70710678118654752]},
{"mesh": 0, "scale": [0.7, 1, 0.5]})"));
  EXPECT_THAT(turned.warnings, IsEmpty());
  EXPECT_LT(error_of(turned, egg), 1e-4);
}

TEST_F(FileNormalsOf, AreAnErrorWhereThereAreNone) {
  const std::string none = "no normals at its vertices, expected them for curved: file_normals";
  const CornerMesh ball = ball_with_normals(0, 0.0);
  const VertexMesh own = unwelded(ball);
  EXPECT_EQ(complaint_about("a.stl", binary_stl(ball.mesh)), "a.stl: has " + none);
  EXPECT_EQ(complaint_about("a.vtp", vtp(own, "", "n")), "a.vtp: has " + none);
  std::string without = gltf(own);
  without.replace(without.find(R"(, "NORMAL": 1)"), 13, "");
  EXPECT_EQ(complaint_about("a.gltf", without), "a.gltf: mesh 'body' has " + none);
  MadeCad cad;
  cad.product(BRepPrimAPI_MakeSphere(1.0).Shape(), "ball");
  cad.write_step(folder_.path() / "a.step");
  EXPECT_EQ(complaint_about("a.step"), "a.step: holds surfaces, not normals at vertices, expected curved: auto");
}

TEST_F(FileNormalsOf, ThatAreNoneAreAnErrorWithTheirPlace) {
  VertexMesh own = unwelded(ball_with_normals(0, 0.0));
  own.normals[7] = Vec3::Zero();
  const std::string expected =
      ": normal 7 as read (from 0), which its face 2 has, is (0, 0, 0), expected a length above 0";
  EXPECT_EQ(complaint_about("a.vtp", vtp(own)), "a.vtp" + expected);
  EXPECT_EQ(complaint_about("a.gltf", gltf(own)), "a.gltf" + expected);
  own.normals[7] = Vec3(0.0, 0.0, NAN);
  EXPECT_EQ(complaint_about("a.gltf", gltf(own)),
            "a.gltf: normal 7 as read (from 0), which its face 2 has, is (nan, nan, nan), expected a length above 0");
  std::string shorts = gltf(own);
  shorts.replace(shorts.find(R"("bufferView": 1, "componentType": 5126)"), 38,
                 R"("bufferView": 1, "componentType": 5122)");
  EXPECT_EQ(complaint_about("a.gltf", shorts),
            "a.gltf: has normals that are not floats, expected glTF without quantization");
}

TEST(Curving, IsReadFromItsOwnWords) {
  for (const char* words : {"auto", "none", "file_normals", "crease:30"})
    EXPECT_EQ(text_of(curving_from_words(words, {})), words);
  EXPECT_EQ(curving_from_words("file_normals", {}).by, By::file_normals);
  for (const char* words : {"", "normals", "file_normals:30", "crease:90"})
    EXPECT_THROW((void)curving_from_words(words, {"scene.yaml", 3, 4}), InputError) << words;
}

}  // namespace
}  // namespace lrcs
