#include "view/arrow_names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lrcs {
namespace {

Box box_of_name(const NamedArrow& arrow, const Point& middle) {
  return {{middle.x - arrow.half_width, middle.y - arrow.half_height},
          {middle.x + arrow.half_width, middle.y + arrow.half_height}};
}

bool boxes_meet(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

// By what of the shaft is left between the box's sides.
bool shaft_meets(const NamedArrow& arrow, const Box& box) {
  double from = 0.0, to = 1.0;
  const auto keep_between = [&](double start, double end, double low, double high) {
    const double span = end - start;
    if (span == 0.0) {
      if (start < low || start > high) to = -1.0;
      return;
    }
    const double a = (low - start) / span, b = (high - start) / span;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  keep_between(arrow.tail.x, arrow.tip.x, box.low.x, box.high.x);
  keep_between(arrow.tail.y, arrow.tip.y, box.low.y, box.high.y);
  return from <= to;
}

// The most wanted first: up or down, as the arrow points; then the other; then beside and askew, near and farther off.
std::vector<Point> candidates(const NamedArrow& arrow) {
  const double up = arrow.tip.y < arrow.tail.y ? -1.0 : 1.0, right = arrow.tip.x < arrow.tail.x ? -1.0 : 1.0;
  std::vector<Point> places;
  for (const double farther : {0.0, 2.0 * arrow.half_height, 4.0 * arrow.half_height}) {
    const double down = arrow.half_height + arrow.clearance + farther;
    const double aside = arrow.half_width + arrow.clearance + farther;
    for (const Point& step : {Point{0.0, up}, Point{0.0, -up}, Point{right, 0.0}, Point{-right, 0.0}, Point{right, up},
                              Point{right, -up}, Point{-right, up}, Point{-right, -up}})
      places.push_back({arrow.tip.x + aside * step.x, arrow.tip.y + down * step.y});
  }
  return places;
}

}  // namespace

std::array<Point, 2> places_of_names(const std::array<NamedArrow, 2>& arrows, const Box& frame, const Box& taken) {
  // Of one name alone.
  const auto trouble = [&](const NamedArrow& arrow, const Box& box) {
    int count = 0;
    for (const NamedArrow& other : arrows) count += shaft_meets(other, box) ? 2 : 0;
    const bool is_inside = box.low.x >= frame.low.x && box.low.y >= frame.low.y && box.high.x <= frame.high.x &&
                           box.high.y <= frame.high.y;
    const bool is_on_tip = std::any_of(arrows.begin(), arrows.end(), [&](const NamedArrow& other) {
      return &other != &arrow && boxes_meet(box, {{other.tip.x - other.clearance, other.tip.y - other.clearance},
                                                  {other.tip.x + other.clearance, other.tip.y + other.clearance}});
    });
    return count + (is_inside ? 0 : 4) + (is_on_tip ? 1 : 0) + (boxes_meet(box, taken) ? 1 : 0);
  };
  std::array<Point, 2> best{};
  int least = std::numeric_limits<int>::max();
  for (const Point& first : candidates(arrows[0]))
    for (const Point& second : candidates(arrows[1])) {
      const Box a = box_of_name(arrows[0], first), b = box_of_name(arrows[1], second);
      const int sum = trouble(arrows[0], a) + trouble(arrows[1], b) + (boxes_meet(a, b) ? 8 : 0);
      if (sum >= least) continue;
      least = sum;
      best = {first, second};
    }
  return best;
}

}  // namespace lrcs
