#pragma once
#include <vector>

#include "view/sweep_plot.h"

namespace lrcs {

// One direction of a cut as drawn. dbsm: 10 log10(sigma / 1 m^2); minus infinity where sigma = 0.
struct CutPoint {
  double angle_deg = 0.0;
  double dbsm = 0.0;
};

// The curve's directions in the order in which to join them.
// value: angles that run one way stay as they are; angles that do so once turns of 360 deg are added (350, 0, 10)
//   get them; any others are sorted. A curve that goes all around gets its first point again, one turn on.
// domain: as Curve; else std::invalid_argument that names the curve.
[[nodiscard]] std::vector<CutPoint> cut_points(const Curve& curve);

// The dBsm that a plot spans. shape: low < high, both whole multiples of step.
// floor_used: something lies below low, and is not drawn. all_zero: nothing lies above minus infinity.
struct DecibelRange {
  double low = -60.0;
  double high = 0.0;
  double step = 10.0;
  bool floor_used = false;
  bool all_zero = false;
};

// value: from somewhat below the lowest point, or 60 dB below the highest where points lie lower, up to the highest;
//   at least `least_span` [dB] in all.
[[nodiscard]] DecibelRange decibel_range(const std::vector<std::vector<CutPoint>>& cuts, double least_span);

// The parts of the joined curve at or above `floor`, cut exactly where they cross it. dBsm is linear in the angle
// between two points; the line breaks beside a point at minus infinity.
[[nodiscard]] std::vector<std::vector<CutPoint>> strokes_above(const std::vector<CutPoint>& cut, double floor);

}  // namespace lrcs
