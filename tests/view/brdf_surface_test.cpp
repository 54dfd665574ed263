#include "view/brdf_surface.h"

#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "plot_frame.h"
#include "view/hemisphere_view.h"

namespace lrcs {
namespace {

using Field = std::function<double(double theta_deg, double phi_deg)>;

HemisphereValues sampled(const Field& field) {
  HemisphereValues values;
  for (int theta = 0; theta <= 80; theta += 2) values.theta_r_deg.push_back(theta);
  for (int phi = 0; phi < 360; phi += 2) values.phi_deg.push_back(phi);
  for (const double theta : values.theta_r_deg)
    for (const double phi : values.phi_deg) values.value.push_back(field(theta, phi));
  return values;
}

// A hill on the disc of directions.
Field hill(double theta_deg, double phi_deg, double height, double width_deg) {
  return [=](double theta, double phi) {
    constexpr double degree = std::numbers::pi / 180.0;
    const double dx = theta * std::cos(phi * degree) - theta_deg * std::cos(phi_deg * degree);
    const double dy = theta * std::sin(phi * degree) - theta_deg * std::sin(phi_deg * degree);
    return height * std::exp(-(dx * dx + dy * dy) / (width_deg * width_deg));
  };
}

std::filesystem::path drawn(const std::string& name, const Field& field, double full_scale = 0.0) {
  const auto png = scratch_file(name);
  draw_brdf_surface(png, sampled(field), {"Surface", "a note", "BRDF [1/sr]", full_scale});
  return png;
}

// The highest pixel of the yellow end of the colours, left of the colour bar.
std::array<double, 2> top_of_hill(const PngPixels& pixels) {
  for (int row = pixels.size[1] - 1; row >= 0; --row)
    for (int column = 0; column < 1300; ++column)
      if (pixels.is(viridis(0.97), column, row, 35)) return {column + 0.5, row + 0.5};
  return {};
}

// Azimuths that are on the left and on the right as seen by the viewer, as far away as the middle.
constexpr double rightward = HemisphereView::viewer_azimuth_deg + 90.0;
constexpr double leftward = HemisphereView::viewer_azimuth_deg + 270.0;

// The upright lines at the ends of the wall: left and right end of the disc.
std::vector<double> ends_of_disc(const PngPixels& pixels) {
  const auto lines = ink_lines(pixels, false, 300);
  return {lines[0], lines[1]};
}

TEST(BrdfSurface, IsHighestWhereTheMaximumIs) {
  for (const double phi : {leftward, rightward}) {
    const PngPixels pixels(drawn("surface.png", hill(60.0, phi, 1.0, 12.0)));
    EXPECT_EQ(pixels.size[0], 1600);
    EXPECT_EQ(pixels.size[1], 1300);
    const auto ends = ends_of_disc(pixels);
    const double side = phi == leftward ? -1.0 : 1.0;
    const double middle = 0.5 * (ends[0] + ends[1]), half = 0.5 * (ends[1] - ends[0]);
    EXPECT_NEAR(top_of_hill(pixels)[0], middle + side * half * 60.0 / 80.0, 6.0);
  }
}

TEST(BrdfSurface, RisesToItsValueOnTheUprightAxis) {
  const PngPixels pixels(drawn("surface.png", hill(60.0, leftward, 1.0, 12.0)));
  const int beside_axis = static_cast<int>(ends_of_disc(pixels)[0]) - 6;  // only its ticks reach there
  int row = 1000;
  while (row > 0 && !pixels.is(ink, beside_axis, row)) --row;
  EXPECT_NEAR(top_of_hill(pixels)[1], row, 6.0);
}

TEST(BrdfSurface, PutsTheTransmittersSideRightAndTheSpecularSideLeft) {
  const double right = top_of_hill(PngPixels(drawn("surface.png", hill(50.0, 0.0, 1.0, 12.0))))[0];
  const double left = top_of_hill(PngPixels(drawn("surface.png", hill(50.0, 180.0, 1.0, 12.0))))[0];
  EXPECT_GT(right, left + 300.0);
}

TEST(BrdfSurface, HidesWhatLiesBehind) {
  constexpr double ahead = HemisphereView::viewer_azimuth_deg + 360.0;
  const Field ridge = hill(40.0, ahead, 1.0, 25.0);
  const Field behind = hill(20.0, ahead - 180.0, 0.15, 4.0);
  const Field flat = hill(40.0, ahead, 0.02, 25.0);
  const auto with = [](const Field& a, const Field& b) {
    return [=](double theta, double phi) { return std::max(a(theta, phi), b(theta, phi)); };
  };
  EXPECT_EQ(bytes_of(drawn("a.png", ridge)), bytes_of(drawn("b.png", with(ridge, behind))));
  EXPECT_NE(bytes_of(drawn("a.png", flat, 1.0)), bytes_of(drawn("b.png", with(flat, behind), 1.0)));
}

TEST(BrdfSurface, TakesItsColoursFromViridisOverTheAxis) {
  const auto constant = [](double /*theta*/, double /*phi*/) { return 0.5; };
  EXPECT_GT(find_colour(PngPixels(drawn("g.png", constant, 1.0)), viridis(0.5)).count, 100000);
  EXPECT_GT(find_colour(PngPixels(drawn("f.png", constant)), viridis(1.0)).count, 100000);
}

TEST(BrdfSurface, HasAColourBarRightOfTheSurface) {
  const PngPixels pixels(drawn("surface.png", hill(0.0, 0.0, 1.0, 20.0)));
  const int column = 1412;
  int first = 0, last = 0;
  for (int row = 0; row < pixels.size[1]; ++row) {
    if (pixels.is(viridis(0.0), column, row, 6) && first == 0) first = row;
    if (pixels.is(viridis(1.0), column, row, 6)) last = row;
  }
  EXPECT_GT(last, first + 300);
  EXPECT_TRUE(pixels.is(viridis(0.5), column, (first + last) / 2, 12));
}

TEST(BrdfSurface, DrawsWhatIsZeroThroughout) {
  const auto zero = [](double /*theta*/, double /*phi*/) { return 0.0; };
  EXPECT_GT(find_colour(PngPixels(drawn("zero.png", zero)), viridis(0.0)).count, 100000);
}

TEST(BrdfSurface, GivesTheSameBytesTwice) {
  const Field field = hill(30.0, 200.0, 0.3, 15.0);
  EXPECT_EQ(bytes_of(drawn("first.png", field)), bytes_of(drawn("second.png", field)));
}

TEST(BrdfSurface, NeedsNeitherDisplayNorXServer) {
  const auto png = scratch_file("surface.png");
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        unsetenv("DISPLAY");
        setenv("PATH", "/nonexistent", 1);
        draw_brdf_surface(png, sampled(hill(30.0, 200.0, 0.3, 15.0)), {"Surface", "", "BRDF [1/sr]"});
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST(BrdfSurface, RefusesValuesThatCannotBe) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto png = scratch_file("surface.png");
  const HemisphereValues good{{0.0, 40.0}, {0.0, 120.0, 240.0}, {1.0, 1.0, 1.0, 2.0, 3.0, 4.0}};
  const auto refuses = [&](const std::function<void(HemisphereValues&)>& spoil) {
    HemisphereValues values = good;
    spoil(values);
    EXPECT_THROW(draw_brdf_surface(png, values, {}), std::invalid_argument);
  };
  refuses([](HemisphereValues& v) { v = {}; });
  refuses([](HemisphereValues& v) { v.value.pop_back(); });
  refuses([](HemisphereValues& v) { v.value[2] = nan; });
  refuses([](HemisphereValues& v) { v.value[2] = -1.0; });
  refuses([](HemisphereValues& v) { v.value[2] = std::numeric_limits<double>::infinity(); });
  refuses([](HemisphereValues& v) { v.theta_r_deg[0] = 1.0; });
  refuses([](HemisphereValues& v) { v.theta_r_deg[1] = 91.0; });
  refuses([](HemisphereValues& v) { v.theta_r_deg[1] = nan; });
  refuses([](HemisphereValues& v) { v.phi_deg[2] = 360.0; });
  refuses([](HemisphereValues& v) { v.phi_deg[2] = 100.0; });
  EXPECT_FALSE(std::filesystem::exists(png));
  draw_brdf_surface(png, good, {});
  EXPECT_TRUE(std::filesystem::exists(png));
}

}  // namespace
}  // namespace lrcs
