#include "mesh/body_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "made_meshes.h"

namespace lrcs {
namespace {

FacetMesh placed(double unit, const std::string& forward, const std::string& up) {
  FacetMesh mesh = mesh_of({{1, 2, 3}, {4, 5, 6}, {0, 0, 1}}, {{0, 1, 2}});
  place_in_body_frame(mesh, unit, forward, up);
  return mesh;
}

std::string complaint(double unit, const std::string& forward, const std::string& up) {
  try {
    placed(unit, forward, up);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(BodyFrame, LeavesAFileThatIsInTheBodyFrameAsItIs) {
  EXPECT_EQ(placed(1.0, "+x", "+z").positions[0], Vec3(1, 2, 3));
  EXPECT_EQ(placed(1.0, "x", "z").positions[0], Vec3(1, 2, 3));
}

TEST(BodyFrame, BringsForwardToXAndUpToZ) {
  // Forward -z, up +y: the left hand is at up x forward = y x (-z) = -x.
  EXPECT_EQ(placed(1.0, "-z", "+y").positions[0], Vec3(-3, -1, 2));
  EXPECT_EQ(placed(1.0, "+y", "+z").positions[0], Vec3(2, -1, 3));
}

TEST(BodyFrame, KeepsTheFilesCoordinatesAndSaysTheirUnit) {
  const FacetMesh mesh = placed(0.001, "+x", "+z");
  EXPECT_EQ(mesh.positions[1], Vec3(4, 5, 6));
  EXPECT_EQ(mesh.metres_per_unit, 0.001);
}

TEST(BodyFrame, IsARotationForEveryPairOfAxes) {
  const std::vector<std::string> axes{"+x", "-x", "+y", "-y", "+z", "-z"};
  int frames = 0;
  for (const auto& forward : axes) {
    for (const auto& up : axes) {
      if (forward[1] == up[1]) continue;
      FacetMesh mesh = unit_box();
      place_in_body_frame(mesh, 1.0, forward, up);
      double volume = 0.0;
      for (std::size_t k = 0; k < mesh.size(); ++k)
        volume += mesh.areas[k] * mesh.normals[k].dot(mesh.corners(k)[0]) / 3.0;
      EXPECT_NEAR(volume, 1.0, 1e-15);
      ++frames;
    }
  }
  EXPECT_EQ(frames, 24);
}

TEST(BodyFrame, HasNoNegativeZeros) {
  EXPECT_FALSE(std::signbit(placed(1.0, "-x", "+z").positions[2].x()));
}

TEST(BodyFrame, MeasuresTheFacetsInSquareMetres) {
  FacetMesh mesh = unit_box();
  place_in_body_frame(mesh, 0.5, "+x", "+z");
  EXPECT_EQ(mesh.areas[0], 0.125);
}

TEST(BodyFrame, RefusesAxesAlongOneLine) {
  EXPECT_EQ(complaint(1.0, "+x", "-x"), "forward +x and up -x lie along the same axis, expected two different axes");
}

TEST(BodyFrame, RefusesAWordThatIsNoAxis) {
  EXPECT_EQ(complaint(1.0, "north", "+z"), "'north' is no axis, expected one of +x -x +y -y +z -z");
  EXPECT_EQ(complaint(1.0, "+x", ""), "'' is no axis, expected one of +x -x +y -y +z -z");
  EXPECT_EQ(complaint(1.0, "+x", "+yz"), "'+yz' is no axis, expected one of +x -x +y -y +z -z");
}

TEST(BodyFrame, RefusesAUnitThatIsNoLength) {
  EXPECT_EQ(complaint(0.0, "+x", "+z"), "a unit of 0 m, expected a length above zero");
  EXPECT_EQ(complaint(NAN, "+x", "+z"), "a unit of nan m, expected a length above zero");
}

}  // namespace
}  // namespace lrcs
