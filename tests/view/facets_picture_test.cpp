#include "view/facets_picture.h"

#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "png_pixels.h"
#include "two_plates.h"
#include "view/facet_colours.h"
#include "view/parallel_view.h"

namespace lrcs {
namespace {

void draw(const std::filesystem::path& png, const TwoPlates& plates) {
  draw_facets_picture(png, plates.mesh, plates.result, Vec3::UnitX(), Vec3::UnitZ(), 800, 600);
}

TEST(FacetsPicture, HasItsSizeAndShowsBrightDimAndUnseenFacets) {
  unsetenv("DISPLAY");
  const auto png = scratch_file("facets.png");
  const TwoPlates plates = two_plates();
  draw(png, plates);
  const PngPixels pixels(png);
  EXPECT_EQ(pixels.size[0], 800);
  EXPECT_EQ(pixels.size[1], 600);
  const auto colours = coloured_facets(plates.mesh, plates.result, {}).colours;
  // Seen 30 deg from the side and 25 deg from above, unseen facets are darker; the others are as their scale.
  const double facing = std::cos(30.0 * degree) * std::cos(25.0 * degree);
  const auto seen = [&](std::size_t facet) {
    const Rgb rgb = facet == 1 ? drawn_colour(unseen_grey, false, facing) : rgb_of(colours[facet]);
    return find_colour(pixels, {rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0});
  };
  EXPECT_GT(seen(0).count, 5000);
  EXPECT_GT(seen(1).count, 5000);
  EXPECT_GT(seen(2).count, 5000);
  // Seen from +x with z up, y grows to the right.
  EXPECT_LT(seen(0).column, seen(2).column);
  // The facet below the diagonal lies below the one above it.
  EXPECT_LT(seen(0).row, seen(1).row);
}

TEST(FacetsPicture, GivesTheSameBytesTwice) {
  const auto first = scratch_file("first.png");
  const auto second = scratch_file("second.png");
  draw(first, two_plates());
  draw(second, two_plates());
  EXPECT_EQ(bytes_of(first), bytes_of(second));
}

TEST(FacetsPicture, WorksWithoutHomeInABareEnvironment) {
  const auto png = scratch_file("facets.png");
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        const std::string path = std::getenv("PATH");
        clearenv();
        setenv("PATH", path.c_str(), 1);
        draw(png, two_plates());
        std::exit(std::filesystem::exists(png) ? 0 : 1);
      },
      testing::ExitedWithCode(0), "^$");
}

TEST(FacetsPicture, SaysInOneLineThatThereIsNoWayToDraw) {
  const auto png = scratch_file("facets.png");
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        unsetenv("DISPLAY");
        setenv("PATH", "/nonexistent", 1);
        try {
          draw(png, two_plates());
        } catch (const std::runtime_error& error) {
          std::cerr << error.what();
          std::exit(7);
        }
      },
      testing::ExitedWithCode(7), "^3-D pictures cannot be drawn here: Xvfb is not installed .*DISPLAY is not set$");
  EXPECT_FALSE(std::filesystem::exists(png));
}

TEST(FacetsPicture, RefusesWhatItCannotShow) {
  const auto png = scratch_file("facets.png");
  const TwoPlates plates = two_plates();
  const auto draw_with = [&](const Vec3& toward, const Vec3& up, int width) {
    draw_facets_picture(png, plates.mesh, plates.result, toward, up, width, 600);
  };
  EXPECT_THROW(draw_with(Vec3::Zero(), Vec3::UnitZ(), 800), std::invalid_argument);
  EXPECT_THROW(draw_with(Vec3::UnitX(), Vec3::Zero(), 800), std::invalid_argument);
  EXPECT_THROW(draw_with(Vec3::UnitX(), Vec3::UnitZ(), 10), std::invalid_argument);
  EXPECT_THROW(draw_facets_picture(png, {}, {}, Vec3::UnitX(), Vec3::UnitZ(), 800, 600), std::invalid_argument);
}

TEST(ParallelView, ShowsTheWholeMeshWithoutStretchingIt) {
  const FacetMesh mesh = two_plates().mesh;
  const Box box{{10.0, 20.0}, {510.0, 320.0}};
  for (const Vec3& toward : {Vec3(1.0, 0.2, 0.1), Vec3(0.0, 0.0, 1.0), Vec3(-1.0, 0.0, 0.0), Vec3(0.0, 3.0, 0.0)}) {
    const ParallelView view = view_of(mesh, toward, Vec3::UnitZ(), box);
    EXPECT_NEAR(view.right.cross(view.up).dot(view.backward), 1.0, 1e-12);
    for (const Vec3& p : mesh.positions) {
      EXPECT_GE(view.at(p).x, box.low.x - 1e-9);
      EXPECT_LE(view.at(p).x, box.high.x + 1e-9);
      EXPECT_GE(view.at(p).y, box.low.y - 1e-9);
      EXPECT_LE(view.at(p).y, box.high.y + 1e-9);
    }
  }
}

}  // namespace
}  // namespace lrcs
