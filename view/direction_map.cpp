#include "view/direction_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "view/colour_bar.h"
#include "view/plot_header.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

void require_valid(const DirectionMap& map) {
  const auto refuse = [](const char* what) {
    throw std::invalid_argument(std::string("a map of directions: ") + what);
  };
  for (const auto* angles : {&map.azimuth_deg, &map.elevation_deg}) {
    if (angles->size() < 2) refuse("two azimuths and two elevations are needed");
    if (std::adjacent_find(angles->begin(), angles->end(), std::greater_equal<>()) != angles->end())
      refuse("its angles must rise");
  }
  if (map.elevation_deg.front() < -90.0 || map.elevation_deg.back() > 90.0) refuse("an elevation is beyond a pole");
  if (map.sigma_m2.size() != map.azimuth_deg.size() * map.elevation_deg.size())
    refuse("a value for each direction is needed");
  const auto is_wrong = [](double sigma) { return sigma < 0.0 || std::isinf(sigma); };
  if (std::any_of(map.sigma_m2.begin(), map.sigma_m2.end(), is_wrong)) refuse("a LRCS is not finite and >= 0");
}

// One more than there are angles.
std::vector<double> edges_between(const std::vector<double>& angles) {
  std::vector<double> edges{1.5 * angles[0] - 0.5 * angles[1]};
  for (std::size_t i = 1; i < angles.size(); ++i) edges.push_back(0.5 * (angles[i - 1] + angles[i]));
  edges.push_back(1.5 * angles.back() - 0.5 * angles[angles.size() - 2]);
  return edges;
}

}  // namespace

std::vector<MapCell> map_cells(const DirectionMap& map) {
  require_valid(map);
  const std::vector<double> across = edges_between(map.azimuth_deg);
  std::vector<double> up = edges_between(map.elevation_deg);
  for (double& edge : up) edge = std::clamp(edge, -90.0, 90.0);
  std::vector<MapCell> cells;
  for (std::size_t e = 0; e + 1 < up.size(); ++e)
    for (std::size_t a = 0; a + 1 < across.size(); ++a) {
      const double sigma = map.sigma_m2[e * map.azimuth_deg.size() + a];
      if (!std::isnan(sigma)) cells.push_back({across[a], across[a + 1], up[e], up[e + 1], sigma});
    }
  return cells;
}

DecibelRange map_range(const DirectionMap& map, std::optional<double> floor_dbsm) {
  constexpr double least_span = 1.0;  // [dB]
  std::vector<CutPoint> points;
  for (const MapCell& cell : map_cells(map)) points.push_back({0.0, 10.0 * std::log10(cell.sigma_m2)});
  return decibel_range({points}, least_span, floor_dbsm);
}

Colour map_colour(const DecibelRange& range, double sigma_m2) {
  const double share = (10.0 * std::log10(sigma_m2) - range.low) / (range.high - range.low);
  return viridis(std::clamp(share, 0.0, 1.0));
}

std::string map_note(const DirectionMap& map, const DecibelRange& range) {
  const bool gaps = map_cells(map).size() < map.sigma_m2.size();
  std::string note;
  if (range.all_zero) note = "LRCS is 0 m² in every direction";
  if (range.floor_used) note = "Darkest: LRCS is 0 or below " + floor_label(range) + " dBsm";
  if (gaps) note += (note.empty() ? "White: not computed" : "; white: not computed");
  return note;
}

void draw_map_bar(Canvas& canvas, double bottom, double top, const DecibelRange& range) {
  constexpr double before = 50.0, width = 40.0, border = 26.0;  // [pixel]
  const double left = canvas.width() - map_bar_room + before;
  Axis axis{"LRCS [dBsm]", range.low, range.high, multiples(range.low, range.high, range.step), {}};
  for (const double mark : axis.marks) axis.labels.push_back(tick_label(mark, range.step));
  draw_colour_bar(canvas, {{left, bottom}, {left + width, top}}, axis);
  canvas.text({canvas.width() - border, 0.5 * (bottom + top)}, axis.title,
              {.font = fitting(axis.title, axis_font, top - bottom), .x = AlignX::centre, .upward = true});
}

}  // namespace lrcs
