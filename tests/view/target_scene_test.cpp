#include "view/target_scene.h"

#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/direction.h"
#include "two_plates.h"
#include "view/facet_colours.h"

namespace lrcs {
namespace {

// Pixels of exactly this colour: arrows are shaded, so they are letters, mostly.
int letters_of(const Picture& picture, const Colour& colour) {
  const Rgb wanted = rgb_of(colour);
  int count = 0;
  for (std::size_t k = 0; k < picture.rgb.size(); k += 3)
    if (std::equal(wanted.begin(), wanted.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(k))) ++count;
  return count;
}

// Whatever the angle between transmitter and receiver, neither name covers the other.
TEST(TargetScene, KeepsNamesOfArrowsApart) {
  const TwoPlates plates = two_plates();
  TargetScene scene(plates.mesh);
  scene.colour(std::vector<Colour>(plates.mesh.size(), unseen_grey));
  const Colour of_transmitter = curve_colour(1);
  for (const auto& [angle_deg, elevation_deg] :
       std::vector<std::pair<double, double>>{{0.5, 0.0}, {3.0, 30.0}, {8.0, -20.0}}) {
    const Vec3 receiver = direction_of({10.0 + angle_deg, elevation_deg + 0.5 * angle_deg});
    scene.point_at(direction_of({10.0, elevation_deg}), receiver);
    scene.look_beside(receiver);
    const Picture both = scene.picture(400, 350, 14);
    scene.show_receiver(false);
    const Picture alone = scene.picture(400, 350, 14);
    scene.show_receiver(true);
    const int all = letters_of(alone, of_transmitter);
    EXPECT_GT(all, 50);
    EXPECT_GT(letters_of(both, of_transmitter), 0.9 * all) << angle_deg << " " << elevation_deg;
  }
}

// A wing seen along its span: arrows stand far off, as its tips do.
TEST(TargetScene, HasRoomForArrowsWhereverTheyPoint) {
  FacetMesh wing;
  wing.positions = {{0.0, -5.0, -0.5}, {0.0, 5.0, -0.5}, {0.0, 5.0, 0.5}, {0.0, -5.0, 0.5}};
  wing.facets = {{0, 1, 2}, {0, 2, 3}};
  measure_facets(wing);
  TargetScene scene(wing);
  scene.colour(std::vector<Colour>(wing.size(), unseen_grey));
  const Vec3 receiver = direction_of({239.78, -18.87});
  scene.point_at(direction_of({136.32, 8.27}), receiver);
  scene.look_beside(receiver);
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{350, 470}, {250, 700}}) {
    scene.fit(static_cast<double>(width) / height);
    const Picture picture = scene.picture(width, height, 14);
    EXPECT_GT(letters_of(picture, curve_colour(1)), 50) << width;
    EXPECT_GT(letters_of(picture, ink), 30) << width;
    for (int row = 0; row < height; ++row)
      for (const int column : {0, width - 1})
        ASSERT_EQ(picture.rgb[3 * static_cast<std::size_t>(row * width + column) + 2], 255) << width << " " << row;
  }
}

// Of an arrow behind the target, too, as after the window's own fitting of depths.
TEST(TargetScene, DrawsNamesBeforeTheTarget) {
  const TwoPlates plates = two_plates();
  TargetScene scene(plates.mesh);
  scene.colour(std::vector<Colour>(plates.mesh.size(), unseen_grey));
  const Vec3 toward_viewer = direction_of({20.0, 10.0});
  scene.point_at(-direction_of({45.0, 10.0}), direction_of({80.0, 10.0}));
  scene.look_from(toward_viewer);
  EXPECT_GT(letters_of(scene.picture(400, 350, 14), curve_colour(1)), 50);
  scene.renderer()->ResetCameraClippingRange();
  EXPECT_GT(letters_of(scene.picture(400, 350, 14), curve_colour(1)), 50);
}

}  // namespace
}  // namespace lrcs
