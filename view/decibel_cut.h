#pragma once
#include <optional>
#include <string>
#include <vector>

#include "view/sweep_plot.h"

namespace lrcs {

// One direction of a cut as drawn. dbsm: 10 log10(sigma / 1 m^2); minus infinity where sigma = 0. low, high: the same
// of sigma - bound (or 0) and of sigma + bound; dbsm where the curve has no bounds.
struct CutPoint {
  double angle_deg = 0.0;
  double dbsm = 0.0;
  double low_dbsm = dbsm;
  double high_dbsm = dbsm;
};

// The curve's directions in the order in which to join them.
// goes_round: the angles are azimuths or elevations; else they are as given, in rising order.
// value: angles that run one way stay as they are; angles that do so once turns of 360 deg are added (350, 0, 10)
//   get them; any others are sorted. A curve that goes all around gets its first point again, one turn on.
// domain: as Curve; else std::invalid_argument that names the curve.
[[nodiscard]] std::vector<CutPoint> cut_points(const Curve& curve, bool goes_round = true);

// The dBsm that a plot spans. shape: low < high, whole multiples of step; a low that was asked for is as asked.
// floor_used: something lies below low, and is not drawn. all_zero: nothing lies above minus infinity.
struct DecibelRange {
  double low = -60.0;
  double high = 0.0;
  double step = 10.0;
  bool floor_used = false;
  bool all_zero = false;
};

// value: from somewhat below the lowest point, or 60 dB below the highest where points lie lower, up to the highest;
//   at least `least_span` [dB] in all. From `floor`, where it is given, up to the highest.
// domain: floor below the highest point, unless all are zero; else std::invalid_argument.
[[nodiscard]] DecibelRange decibel_range(const std::vector<std::vector<CutPoint>>& cuts, double least_span,
                                         std::optional<double> floor = std::nullopt);

// The lowest dBsm drawn, without its unit: "−40".
[[nodiscard]] std::string floor_label(const DecibelRange& range);

// The parts of the joined curve at or above `floor`, cut exactly where they cross it. dBsm is linear in the angle
// between two points; the line breaks beside a point at minus infinity.
[[nodiscard]] std::vector<std::vector<CutPoint>> strokes_above(const std::vector<CutPoint>& cut, double floor);

}  // namespace lrcs
