#include "lrcs/layer_count.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>

namespace lrcs {
namespace {

// What lies outside the facet counts as more layers than edges can take away.
constexpr int outside = 1 << 28;

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

}  // namespace

void LayerCount::take_edges(std::span<const LayerEdge> edges) {
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
}

double LayerCount::uncovered_area(std::span<const LayerEdge> edges, double tolerance, int layers_at_left) {
  tolerance_ = tolerance;
  layers_at_left_ = layers_at_left;
  negative_area_ = 0.0;
  take_edges(edges);
  place_.resize(edges_.size());
  double area = 0.0;
  std::size_t next = 0;
  active_.clear();
  for (std::size_t k = 0; k + 1 < heights_.size(); ++k) {
    const double low = heights_[k];
    std::erase_if(active_, [&](std::uint32_t e) { return edges_[e].v1 <= low; });
    for (; next < edges_.size() && edges_[next].v0 <= low; ++next) active_.push_back(static_cast<std::uint32_t>(next));
    collect_slab(low, heights_[k + 1]);
    slab_height_ = heights_[k + 1] - low;
    area += slab_height_ * slab_area();
  }
  return area;
}

// What passes the slab left of the facet only adds layers, what passes right of it is never reached.
void LayerCount::collect_slab(double low, double high) {
  lines_.clear();
  int layers_at_left_side = layers_at_left_;
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
void LayerCount::snap(double Line::*end) {
  std::sort(lines_.begin(), lines_.end(), [end](const Line& a, const Line& b) { return a.*end < b.*end; });
  double first = lines_.front().*end;
  for (Line& line : lines_) {
    if (line.*end - first > tolerance_) first = line.*end;
    line.*end = first;
  }
}

bool LayerCount::Crossing::operator>(const Crossing& other) const {
  return std::tie(height, left, right) > std::tie(other.height, other.left, other.right);
}

// Notes where a line meets its right neighbour, if it does below the top.
void LayerCount::expect_crossing(std::size_t left) {
  const Line &a = lines_[left], &b = lines_[left + 1];
  if (a.top <= b.top) return;
  const double apart_below = b.bottom - a.bottom;
  crossings_.push_back({apart_below / (apart_below + (a.top - b.top)), a.rank, b.rank});
  std::push_heap(crossings_.begin(), crossings_.end(), std::greater<>());
}

double LayerCount::gap_area(std::size_t left, double height) {
  const Gap& gap = gaps_[left];
  if (gap.layers > 0) return 0.0;
  const double below = lines_[left + 1].bottom - lines_[left].bottom;
  const double above = lines_[left + 1].top - lines_[left].top;
  const double middle = 0.5 * (gap.since + height);
  const double area = (height - gap.since) * (below + middle * (above - below));
  if (gap.layers == 0) return area;
  negative_area_ += slab_height_ * area;
  return 0.0;
}

// Area of the gaps between the layers, in units of the slab's height. Two lines that change places are then in the
// order they have at the top, and stay so: every pair crosses once at most, in whatever order rounding lets crossings
// come.
double LayerCount::slab_area() {
  snap(&Line::top);
  snap(&Line::bottom);
  std::sort(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) {
    return std::tie(a.bottom, a.top, a.rank) < std::tie(b.bottom, b.top, b.rank);
  });
  gaps_.clear();
  crossings_.clear();
  int layers = outside;
  for (std::uint32_t k = 0; k < lines_.size(); ++k) {
    layers += lines_[k].step;
    gaps_.push_back({layers, 0.0});
    place_[lines_[k].rank] = k;
    if (k + 1 < lines_.size()) expect_crossing(k);
  }
  double area = 0.0;
  double height = 0.0;
  const auto last = lines_.size() - 1;
  while (!crossings_.empty()) {
    std::pop_heap(crossings_.begin(), crossings_.end(), std::greater<>());
    const Crossing crossing = crossings_.back();
    crossings_.pop_back();
    const std::size_t k = place_[crossing.left];
    if (place_[crossing.right] != k + 1) continue;  // no longer, or not yet, neighbours
    height = std::max(height, crossing.height);
    const std::size_t first_gap = k > 0 ? k - 1 : 0, last_gap = std::min(k + 1, last - 1);
    for (std::size_t gap = first_gap; gap <= last_gap; ++gap) {
      area += gap_area(gap, height);
      gaps_[gap].since = height;
    }
    std::swap(lines_[k], lines_[k + 1]);
    std::swap(place_[crossing.left], place_[crossing.right]);
    gaps_[k].layers += lines_[k].step - lines_[k + 1].step;
    if (k > 0) expect_crossing(k - 1);
    if (k + 2 <= last) expect_crossing(k + 1);
  }
  for (std::size_t gap = 0; gap < last; ++gap) area += gap_area(gap, 1.0);
  return area;
}

}  // namespace lrcs
