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

}  // namespace

// Turns edges upward and keeps what of them lies between v = 0 and v = 1.
void LayerCount::take_edges(std::span<const LayerEdge> edges) {
  edges_.clear();
  edges_.push_back({{0.0, 0.0, 0.0, 1.0, -outside}, 0.0});
  edges_.push_back({{1.0, 0.0, 0.0, 1.0, +outside}, -1.0});
  heights_.assign({0.0, 1.0});
  for (const LayerEdge& given : edges) {
    Edge e{given, 0.0};
    if (e.u0 + e.v0 >= 1.0 && e.u1 + e.v1 >= 1.0) continue;  // right of the facet
    if (e.v0 > e.v1) {
      std::swap(e.u0, e.u1);
      std::swap(e.v0, e.v1);
    }
    if (e.v1 <= 0.0 || e.v0 >= 1.0 || e.v0 == e.v1) continue;
    e.slope = (e.u1 - e.u0) / (e.v1 - e.v0);
    if (!std::isfinite(e.slope)) e.slope = 0.0;  // no height lies between its ends
    const double at_bottom = e.u_at(0.0), at_top = e.u_at(1.0);
    if (e.v0 < 0.0) {
      e.u0 = at_bottom;
      e.v0 = 0.0;
    }
    if (e.v1 > 1.0) {
      e.u1 = at_top;
      e.v1 = 1.0;
    }
    edges_.push_back(e);
    heights_.push_back(e.v0);
    heights_.push_back(e.v1);
  }
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.v0 < b.v0; });
  std::sort(heights_.begin(), heights_.end());
  heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
}

double LayerCount::uncovered_area(std::span<const LayerEdge> edges, double tolerance, int layers_at_left) {
  with_moments_ = false;
  return count(edges, tolerance, layers_at_left);
}

AreaMoments LayerCount::uncovered(std::span<const LayerEdge> edges, double tolerance, int layers_at_left) {
  with_moments_ = true;
  moments_ = {};
  moments_.area = count(edges, tolerance, layers_at_left);
  moments_.second(1, 0) = moments_.second(0, 1);
  return moments_;
}

double LayerCount::count(std::span<const LayerEdge> edges, double tolerance, int layers_at_left) {
  tolerance_ = tolerance;
  layers_at_left_ = layers_at_left;
  negative_area_ = 0.0;
  int least = layers_at_left;  // if all that take layers away did so at once
  for (const LayerEdge& e : edges) least += std::min(0, e.step);
  if (least > 0) return 0.0;
  take_edges(edges);
  place_.resize(edges_.size());
  double area = 0.0;
  next_ = 0;
  active_.clear();
  surely_ = layers_at_left;
  for (std::size_t k = 0; k + 1 < heights_.size(); ++k) {
    slab_low_ = heights_[k];
    slab_height_ = heights_[k + 1] - heights_[k];
    if (!pass_to_slab(heights_[k])) continue;
    order_lines(heights_[k], heights_[k + 1]);
    if (collect_lines(heights_[k], heights_[k + 1])) area += slab_height_ * slab_area();
  }
  return area;
}

bool LayerCount::pass_to_slab(double low) {
  const auto share = [this](std::uint32_t edge) {
    const Edge& e = edges_[edge];
    if (std::abs(e.step) == outside) return 0;
    return e.u0 <= 0.0 && e.u1 <= 0.0 ? e.step : std::min(0, e.step);
  };
  std::erase_if(active_, [&](const Line& line) {
    const bool ends = edges_[line.rank].v1 <= low;
    if (ends) surely_ -= share(line.rank);
    return ends;
  });
  for (; next_ < edges_.size() && edges_[next_].v0 <= low; ++next_) {
    const auto edge = static_cast<std::uint32_t>(next_);
    active_.push_back({0.0, 0.0, edges_[next_].step, edge});
    surely_ += share(edge);
  }
  return surely_ <= 0;
}

// Few lines come and go from slab to slab, and few change places: sorting by insertion takes little more than a look.
void LayerCount::order_lines(double low, double high) {
  for (std::size_t k = 0; k < active_.size(); ++k) {
    Line line = active_[k];
    line.bottom = edges_[line.rank].u_at(low);
    line.top = edges_[line.rank].u_at(high);
    const double middle = line.bottom + line.top;
    std::size_t at = k;
    for (; at > 0 && active_[at - 1].bottom + active_[at - 1].top > middle; --at) active_[at] = active_[at - 1];
    active_[at] = line;
  }
}

// What passes the slab left of the facet only adds layers, what passes right of it is never reached.
bool LayerCount::collect_lines(double low, double high) {
  lines_.clear();
  int layers_at_left_side = layers_at_left_, taken_away = 0;
  for (const Line& line : active_) {
    const bool side = std::abs(line.step) == outside;
    const bool left = line.bottom <= 0.0 && line.top <= 0.0;
    const bool right = line.bottom >= 1.0 - low && line.top >= 1.0 - high;
    if (!side && left) {
      layers_at_left_side += line.step;
    } else if (side || !right) {
      lines_.push_back(line);
      if (!side) taken_away += std::min(0, line.step);
    }
  }
  for (Line& line : lines_)
    if (line.step == -outside) line.step += layers_at_left_side;
  return layers_at_left_side + taken_away <= 0;
}

// Which lines are not in the order that they have half way up, at both ends and but for rounding?
void LayerCount::find_crossings() {
  const std::size_t count = lines_.size();
  crosses_.assign(count, 0);
  least_bottom_.resize(count);
  least_top_.resize(count);
  for (std::size_t k = count; k-- > 0;) {
    const bool last = k + 1 == count;
    least_bottom_[k] = last ? lines_[k].bottom : std::min(lines_[k].bottom, least_bottom_[k + 1]);
    least_top_[k] = last ? lines_[k].top : std::min(lines_[k].top, least_top_[k + 1]);
  }
  double most_bottom = lines_.front().bottom, most_top = lines_.front().top;
  for (std::size_t k = 0; k + 1 < count; ++k) {
    most_bottom = std::max(most_bottom, lines_[k].bottom);
    most_top = std::max(most_top, lines_[k].top);
    if (most_bottom > least_bottom_[k + 1] + tolerance_ || most_top > least_top_[k + 1] + tolerance_)
      crosses_[k] = crosses_[k + 1] = 1;
  }
}

// Area of the gaps between the layers, in units of the slab's height.
double LayerCount::slab_area() {
  find_crossings();
  double area = 0.0;
  int layers = outside;
  for (std::size_t k = 0; k + 1 < lines_.size();) {
    const auto is_plain = [&](std::size_t gap) { return crosses_[gap] == 0 && crosses_[gap + 1] == 0; };
    if (is_plain(k)) {
      layers += lines_[k].step;
      const Line &a = lines_[k], &b = lines_[k + 1];
      const double gap = 0.5 * (std::max(0.0, b.bottom - a.bottom) + std::max(0.0, b.top - a.top));
      if (layers == 0) area += gap;
      if (layers == 0 && with_moments_) add_moments(a, b, 0.0, 1.0);
      if (layers < 0) negative_area_ += slab_height_ * gap;
      ++k;
      continue;
    }
    const std::size_t first = k;
    int least = layers + (crosses_[first] != 0 ? std::min(0, lines_[first].step) : lines_[first].step), right = layers;
    for (; k + 1 < lines_.size() && !is_plain(k); ++k) {
      right += lines_[k].step;
      least += std::min(0, lines_[k + 1].step);
    }
    if (least <= 0) area += area_with_crossings(first, k, layers);
    layers = right;
  }
  return area;
}

// Of what lies between two lines from one share of the slab's height to another: Simpson's rule is exact.
void LayerCount::add_moments(const Line& left, const Line& right, double from, double to) {
  for (const double share : {from, 0.5 * (from + to), to}) {
    const double weight = (share == from || share == to ? 1.0 : 4.0) / 6.0 * (to - from) * slab_height_;
    const double l = left.bottom + share * (left.top - left.bottom);
    const double r = right.bottom + share * (right.top - right.bottom);
    const double v = slab_low_ + share * slab_height_, over_row = weight * (r - l), u = 0.5 * (l + r);
    moments_.first += over_row * Eigen::Vector2d(u, v);
    moments_.second(0, 0) += over_row * (l * l + l * r + r * r) / 3.0;
    moments_.second(0, 1) += over_row * u * v;
    moments_.second(1, 1) += over_row * v * v;
  }
}

// Ends that differ by rounding only become equal, so that all later comparisons are plain and agree with each other.
void LayerCount::snap(double Line::*end) {
  std::sort(run_.begin(), run_.end(), [end](const Line& a, const Line& b) { return a.*end < b.*end; });
  double first = run_.front().*end;
  for (Line& line : run_) {
    if (line.*end - first > tolerance_) first = line.*end;
    line.*end = first;
  }
}

bool LayerCount::Crossing::operator>(const Crossing& other) const {
  return std::tie(height, left, right) > std::tie(other.height, other.left, other.right);
}

// Notes where a line meets its right neighbour, if it does below the top.
void LayerCount::expect_crossing(std::size_t left) {
  const Line &a = run_[left], &b = run_[left + 1];
  if (a.top <= b.top) return;
  const double apart_below = b.bottom - a.bottom;
  crossings_.push_back({apart_below / (apart_below + (a.top - b.top)), a.rank, b.rank});
  std::push_heap(crossings_.begin(), crossings_.end(), std::greater<>());
}

double LayerCount::gap_area(std::size_t left, double height) {
  const Gap& gap = gaps_[left];
  if (gap.layers > 0) return 0.0;
  const double below = run_[left + 1].bottom - run_[left].bottom;
  const double above = run_[left + 1].top - run_[left].top;
  const double middle = 0.5 * (gap.since + height);
  const double area = (height - gap.since) * (below + middle * (above - below));
  if (gap.layers == 0 && with_moments_) add_moments(run_[left], run_[left + 1], gap.since, height);
  if (gap.layers == 0) return area;
  negative_area_ += slab_height_ * area;
  return 0.0;
}

// Two lines that change places are then in the order they have at the top, and stay so: every pair crosses once at
// most, in whatever order rounding lets crossings come.
double LayerCount::area_with_crossings(std::size_t first, std::size_t last, int layers) {
  run_.assign(lines_.begin() + static_cast<std::ptrdiff_t>(first),
              lines_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  snap(&Line::top);
  snap(&Line::bottom);
  std::sort(run_.begin(), run_.end(), [](const Line& a, const Line& b) {
    return std::tie(a.bottom, a.top, a.rank) < std::tie(b.bottom, b.top, b.rank);
  });
  gaps_.clear();
  crossings_.clear();
  for (std::uint32_t k = 0; k < run_.size(); ++k) {
    layers += run_[k].step;
    gaps_.push_back({layers, 0.0});
    place_[run_[k].rank] = k;
    if (k + 1 < run_.size()) expect_crossing(k);
  }
  double area = 0.0;
  double height = 0.0;
  const auto end = run_.size() - 1;
  while (!crossings_.empty()) {
    std::pop_heap(crossings_.begin(), crossings_.end(), std::greater<>());
    const Crossing crossing = crossings_.back();
    crossings_.pop_back();
    const std::size_t k = place_[crossing.left];
    if (place_[crossing.right] != k + 1) continue;  // no longer, or not yet, neighbours
    height = std::max(height, crossing.height);
    const std::size_t first_gap = k > 0 ? k - 1 : 0, last_gap = std::min(k + 1, end - 1);
    for (std::size_t gap = first_gap; gap <= last_gap; ++gap) {
      area += gap_area(gap, height);
      gaps_[gap].since = height;
    }
    std::swap(run_[k], run_[k + 1]);
    std::swap(place_[crossing.left], place_[crossing.right]);
    gaps_[k].layers += run_[k].step - run_[k + 1].step;
    if (k > 0) expect_crossing(k - 1);
    if (k + 2 <= end) expect_crossing(k + 1);
  }
  for (std::size_t gap = 0; gap < end; ++gap) area += gap_area(gap, 1.0);
  return area;
}

}  // namespace lrcs
