#include "lrcs/layer_count.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace lrcs {
namespace {

// What lies outside the facet counts as more layers than edges can take away.
constexpr int outside = 1 << 30;

double u_at(const LayerEdge& e, double v) {
  if (v == e.v0) return e.u0;
  if (v == e.v1) return e.u1;
  return e.u0 + (e.u1 - e.u0) * ((v - e.v0) / (e.v1 - e.v0));
}

// Turns the edge upward and keeps what lies between v = 0 and v = 1. False: nothing does.
bool clip_to_unit_height(LayerEdge& e) {
  if (e.v0 > e.v1) {
    std::swap(e.u0, e.u1);
    std::swap(e.v0, e.v1);
  }
  if (e.v1 <= 0.0 || e.v0 >= 1.0 || e.v0 == e.v1) return false;
  const LayerEdge whole = e;
  if (e.v0 < 0.0) {
    e.u0 = u_at(whole, 0.0);
    e.v0 = 0.0;
  }
  if (e.v1 > 1.0) {
    e.u1 = u_at(whole, 1.0);
    e.v1 = 1.0;
  }
  return true;
}

// Order of lines just above the bottom of a slab.
constexpr auto just_above_bottom = [](const auto& a, const auto& b) {
  if (a.bottom != b.bottom) return a.bottom < b.bottom;
  if (a.top != b.top) return a.top < b.top;
  return a.rank < b.rank;
};

}  // namespace

double LayerCount::uncovered_area(const std::vector<LayerEdge>& edges, double tolerance) {
  tolerance_ = tolerance;
  edges_.clear();
  edges_.push_back({0.0, 0.0, 0.0, 1.0, -outside});
  edges_.push_back({1.0, 0.0, 0.0, 1.0, +outside});
  heights_.assign({0.0, 1.0});
  for (LayerEdge e : edges) {
    const bool right_of_facet = e.u0 + e.v0 >= 1.0 && e.u1 + e.v1 >= 1.0;
    if (right_of_facet || !clip_to_unit_height(e)) continue;
    edges_.push_back(e);
    heights_.push_back(e.v0);
    heights_.push_back(e.v1);
  }
  std::sort(edges_.begin(), edges_.end(), [](const LayerEdge& a, const LayerEdge& b) { return a.v0 < b.v0; });
  std::sort(heights_.begin(), heights_.end());
  heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());

  double area = 0.0;
  std::size_t next = 0;
  active_.clear();
  for (std::size_t k = 0; k + 1 < heights_.size(); ++k) {
    const double low = heights_[k];
    std::erase_if(active_, [&](std::uint32_t e) { return edges_[e].v1 <= low; });
    for (; next < edges_.size() && edges_[next].v0 <= low; ++next) active_.push_back(static_cast<std::uint32_t>(next));
    collect_slab(low, heights_[k + 1]);
    area += slab_area(lines_, heights_[k + 1] - low);
  }
  return area;
}

// What passes the slab left of the facet only adds layers, what passes right of it is never reached.
void LayerCount::collect_slab(double low, double high) {
  lines_.clear();
  int layers_at_left_side = 0;
  for (const std::uint32_t e : active_) {
    const Line line{u_at(edges_[e], low), u_at(edges_[e], high), edges_[e].step, e};
    const bool side = std::abs(line.step) == outside;
    const bool left = line.bottom <= 0.0 && line.top <= 0.0;
    const bool right = line.bottom >= 1.0 - low && line.top >= 1.0 - high;
    if (!side && left)
      layers_at_left_side += line.step;
    else if (side || !right)
      lines_.push_back(line);
  }
  for (Line& line : lines_)
    if (line.step == -outside) line.step += layers_at_left_side;
}

// Ends that differ by rounding only become equal, so that all later comparisons are plain and agree with each other.
void LayerCount::snap(Lines& lines, double Line::*end) const {
  std::sort(lines.begin(), lines.end(), [end](const Line& a, const Line& b) { return a.*end < b.*end; });
  double first = lines.front().*end;
  for (Line& line : lines) {
    if (line.*end - first > tolerance_) first = line.*end;
    line.*end = first;
  }
}

// Area of the gaps between the layers. Where two neighbours change places on the way up, the slab is split at their
// crossing: every pair of lines crosses once at most, so this ends.
double LayerCount::slab_area(const Lines& all, double height) {
  struct Part {
    Lines lines;
    double height;
  };
  double area = 0.0;
  std::vector<Part> parts;
  parts.push_back({all, height});
  while (!parts.empty()) {
    Part part = std::move(parts.back());
    parts.pop_back();
    Lines& lines = part.lines;
    snap(lines, &Line::top);
    snap(lines, &Line::bottom);
    std::sort(lines.begin(), lines.end(), just_above_bottom);

    std::size_t k = 0;
    while (k + 1 < lines.size() && lines[k].top <= lines[k + 1].top) ++k;
    if (k + 1 < lines.size()) {
      const double apart_below = lines[k + 1].bottom - lines[k].bottom;
      const double apart_above = lines[k].top - lines[k + 1].top;
      const double t = apart_below / (apart_below + apart_above);
      Part upper{lines, part.height * (1.0 - t)};
      part.height *= t;
      for (std::size_t i = 0; i < lines.size(); ++i)
        lines[i].top = upper.lines[i].bottom = lines[i].bottom + t * (lines[i].top - lines[i].bottom);
      lines[k].top = upper.lines[k].bottom = lines[k + 1].top;
      parts.push_back(std::move(upper));
      parts.push_back(std::move(part));
      continue;
    }
    int layers = outside;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      layers += lines[i].step;
      if (layers == 0)
        area += part.height * 0.5 * ((lines[i + 1].bottom - lines[i].bottom) + (lines[i + 1].top - lines[i].top));
    }
  }
  return area;
}

}  // namespace lrcs
