#include "view/arrow_names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lrcs {
namespace {

// Is some place of the shaft inside the name?
bool strikes_through(const NamedArrow& arrow, const NamedArrow& named, const Point& name) {
  for (int k = 0; k <= 1000; ++k) {
    const double x = std::lerp(arrow.tail.x, arrow.tip.x, k / 1000.0) - name.x;
    const double y = std::lerp(arrow.tail.y, arrow.tip.y, k / 1000.0) - name.y;
    if (std::abs(x) < named.half_width && std::abs(y) < named.half_height) return true;
  }
  return false;
}

TEST(NamesOfArrows, KeepOffShaftsAndEachOther) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(0.0, 6.283), length(0.0, 90.0), apart(-40.0, 40.0);
  const Box frame{{0.0, 0.0}, {800.0, 700.0}};
  for (int k = 0; k < 3000; ++k) {
    std::array<NamedArrow, 2> arrows;
    const double turn = angle(random), about = 0.2 * std::sin(angle(random));
    for (const std::size_t i : {0U, 1U}) {
      const double direction = turn + static_cast<double>(i) * about, size = length(random);
      const Point tail{400.0 + apart(random), 350.0 + apart(random)};
      arrows[i] = {tail,
                   {tail.x + size * std::cos(direction), tail.y + size * std::sin(direction)},
                   i == 0 ? 45.0 : 60.0,
                   12.0,
                   8.0};
    }
    const auto names = places_of_names(arrows, frame);
    for (const std::size_t i : {0U, 1U}) {
      for (const NamedArrow& arrow : arrows) EXPECT_FALSE(strikes_through(arrow, arrows[i], names[i])) << k;
      EXPECT_LT(std::hypot(names[i].x - arrows[i].tip.x, names[i].y - arrows[i].tip.y), 150.0) << k;
    }
    EXPECT_TRUE(std::abs(names[0].x - names[1].x) >= 105.0 || std::abs(names[0].y - names[1].y) >= 24.0) << k;
  }
}

TEST(NamesOfArrows, StandWhereTheArrowPoints) {
  const NamedArrow up{{100.0, 100.0}, {110.0, 150.0}, 30.0, 10.0, 5.0};
  const NamedArrow down{{500.0, 100.0}, {490.0, 50.0}, 30.0, 10.0, 5.0};
  const auto names = places_of_names({up, down}, {{0.0, 0.0}, {800.0, 700.0}});
  EXPECT_EQ(names[0].y, 165.0);
  EXPECT_EQ(names[1].y, 35.0);
}

TEST(NamesOfArrows, KeepOffWhatIsTaken) {
  const NamedArrow arrow{{200.0, 200.0}, {150.0, 160.0}, 60.0, 12.0, 8.0};
  const Box taken{{0.0, 0.0}, {180.0, 155.0}};
  const auto is_off = [&](const Point& name) { return name.x - 60.0 >= taken.high.x || name.y - 12.0 >= taken.high.y; };
  const Box frame{{0.0, 0.0}, {800.0, 700.0}};
  EXPECT_FALSE(is_off(places_of_names({arrow, arrow}, frame)[0]));
  for (const Point& name : places_of_names({arrow, arrow}, frame, taken)) EXPECT_TRUE(is_off(name)) << name.x;
}

TEST(NamesOfArrows, StayInsideTheFrame) {
  const NamedArrow arrow{{100.0, 650.0}, {105.0, 690.0}, 60.0, 12.0, 8.0};
  for (const Point& name : places_of_names({arrow, arrow}, {{0.0, 0.0}, {800.0, 700.0}})) {
    EXPECT_GE(name.x, 60.0);
    EXPECT_LE(name.y, 688.0);
  }
}

}  // namespace
}  // namespace lrcs
