#include "lrcs/facet_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "lrcs/exact_height.h"

namespace lrcs {
namespace {

constexpr double unit_roundoff = 0x1p-53;

double turn_of(double au, double av, double bu, double bv, double cu, double cv) {
  return (bu - au) * (cv - av) - (bv - av) * (cu - au);
}

}  // namespace

void FacetView::look_along(const std::vector<Vec3>& directions) {
  viewers_.resize(directions.size());
  for (std::size_t k = 0; k < directions.size(); ++k) {
    viewers_[k].direction = directions[k];
    viewers_[k].projected.project(tree_, mesh_, directions[k]);
  }
}

// The origin is the vertex opposite to the longest side: the best conditioned coordinates a thin facet can have.
void FacetView::set_frame(std::uint32_t facet) {
  const auto& f = mesh_.facets[facet];
  const auto p = mesh_.corners(facet);
  const std::array<double, 3> opposite{(p[2] - p[1]).squaredNorm(), (p[0] - p[2]).squaredNorm(),
                                       (p[1] - p[0]).squaredNorm()};
  const auto k = static_cast<std::size_t>(std::max_element(opposite.begin(), opposite.end()) - opposite.begin());
  frame_.ids = {f[k], f[(k + 1) % 3], f[(k + 2) % 3]};
  frame_.origin = p[k];
  frame_.e1 = p[(k + 1) % 3] - p[k];
  frame_.e2 = p[(k + 2) % 3] - p[k];
  frame_.normal = facet_cross(p[k], p[(k + 1) % 3], p[(k + 2) % 3]);
}

FacetView::EdgeOn FacetView::edge_on(const Vec3& direction) const {
  const Vec3 terms = frame_.normal.cwiseProduct(direction);
  if (terms.isZero(0.0)) return EdgeOn::exactly;
  // Five roundings of the product, and the direction's own.
  const double rounding = 8.0 * unit_roundoff * frame_.normal.lpNorm<1>();
  return std::abs(terms.sum()) <= rounding ? EdgeOn::perhaps : EdgeOn::no;
}

bool FacetView::one_side_faces_all() const {
  const auto front_faces = [&](const Viewer& viewer) { return frame_.normal.dot(viewer.direction) > 0.0; };
  return front_faces(viewers_.front()) == front_faces(viewers_.back());
}

void FacetView::turn_frame(const Vec3& direction) {
  const double facing = frame_.normal.dot(direction);
  frame_.facing = facing > 0.0 ? 1.0 : -1.0;
  frame_.to_u = frame_.e2.cross(direction) / facing;
  frame_.to_v = direction.cross(frame_.e1) / facing;
  frame_.stretch = 2.0 * std::max(frame_.e1.lpNorm<1>(), frame_.e2.lpNorm<1>()) / std::abs(facing);
  frame_.scale = frame_.normal.lpNorm<1>() / std::abs(facing);
  ++stamp_;
  constexpr std::array<std::array<double, 2>, 3> corner{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
  for (std::size_t k = 0; k < 3; ++k) memo_[frame_.ids[k]] = {corner[k][0], corner[k][1], 0.0, 0.0, stamp_};
}

const FacetView::Seen& FacetView::seen(std::uint32_t vertex) {
  Seen& s = memo_[vertex];
  if (s.stamp == stamp_) return s;
  const Vec3 x = mesh_.positions[vertex] - frame_.origin;
  const Vec3 terms = x.cwiseProduct(frame_.normal);
  s.u = frame_.to_u.dot(x);
  s.v = frame_.to_v.dot(x);
  s.height = frame_.facing * terms.sum();
  // Four roundings each term: difference, normal (two units), product; then two sums.
  s.error = 8.0 * unit_roundoff * terms.lpNorm<1>();
  s.stamp = stamp_;
  return s;
}

void FacetView::refine(std::uint32_t vertex) {
  Seen& s = memo_[vertex];
  if (s.error <= unit_roundoff * std::abs(s.height)) return;
  const auto& p = mesh_.positions;
  s.height = frame_.facing * exact_height(p[frame_.ids[0]], p[frame_.ids[1]], p[frame_.ids[2]], p[vertex]);
  s.error = unit_roundoff * std::abs(s.height);
}

void FacetView::refine_cut(std::uint32_t a, std::uint32_t b, double slack) {
  const Seen &p = memo_[a], &q = memo_[b];
  const bool passes = (p.height > 0.0 && q.height < 0.0) || (p.height < 0.0 && q.height > 0.0);
  if (!passes) return;
  const double length = std::abs(p.u - q.u) + std::abs(p.v - q.v);
  const auto cut_error = [&] {
    const double apart = std::abs(p.height - q.height);
    return (std::abs(p.height) / apart * q.error + std::abs(q.height) / apart * p.error) / apart * length;
  };
  if (cut_error() > slack) {
    refine(a);
    refine(b);
  }
  cut_error_ = std::max(cut_error_, cut_error());
}

bool FacetView::ranks_before(std::uint32_t blocker, std::uint32_t facet, const Vec3& direction) const {
  const bool blocker_front = mesh_.normals[blocker].dot(direction) > 0.0;
  const bool facet_front = frame_.facing > 0.0;
  return blocker_front != facet_front ? blocker_front : blocker < facet;
}

// Adds the layer that `blocker` makes over the facet. True: it covers all of it.
bool FacetView::hidden_by(std::uint32_t blocker, std::uint32_t facet, std::size_t viewer) {
  const auto& ids = mesh_.facets[blocker];
  const std::array<const Seen*, 3> p{&seen(ids[0]), &seen(ids[1]), &seen(ids[2])};
  const auto certainly_behind = [](const Seen* s) { return s->sign_is_certain() && s->height <= 0.0; };
  if (std::all_of(p.begin(), p.end(), certainly_behind) &&
      (p[0]->height < 0.0 || p[1]->height < 0.0 || p[2]->height < 0.0))
    return false;

  double reach = 0.0;
  for (const auto id : ids) reach = std::max(reach, (mesh_.positions[id] - frame_.origin).cwiseAbs().maxCoeff());
  // Less overlap than the coordinates' rounding error is no overlap.
  const double slack = 8.0 * unit_roundoff * std::max(1.0, reach * frame_.stretch);
  const auto [u0, u1] = std::minmax({p[0]->u, p[1]->u, p[2]->u});
  const auto [v0, v1] = std::minmax({p[0]->v, p[1]->v, p[2]->v});
  const double sum0 = std::min({p[0]->u + p[0]->v, p[1]->u + p[1]->v, p[2]->u + p[2]->v});
  if (u1 <= slack || v1 <= slack || u0 >= 1.0 || v0 >= 1.0 || sum0 >= 1.0 - slack) return false;
  const int turn = turn_of(p[0]->u, p[0]->v, p[1]->u, p[1]->v, p[2]->u, p[2]->v) >= 0.0 ? 1 : -1;
  bool covers = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Seen &a = *p[k], &b = *p[(k + 1) % 3];
    const double at0 = turn * turn_of(a.u, a.v, b.u, b.v, 0.0, 0.0);
    const double at1 = turn * turn_of(a.u, a.v, b.u, b.v, 1.0, 0.0);
    const double at2 = turn * turn_of(a.u, a.v, b.u, b.v, 0.0, 1.0);
    const double length = std::abs(b.u - a.u) + std::abs(b.v - a.v);
    if (std::max({at0, at1, at2}) <= slack * length) return false;
    covers = covers && std::min({at0, at1, at2}) >= 0.0;
  }

  for (std::size_t k = 0; k < 3; ++k)
    if (!p[k]->sign_is_certain()) refine(ids[k]);
  const auto [low, high] = std::minmax({p[0]->height, p[1]->height, p[2]->height});
  if (low == 0.0 && high == 0.0) {
    if (!ranks_before(blocker, facet, viewers_[viewer].direction)) return false;
  } else if (high <= 0.0) {
    return false;
  }
  reach_ = std::max(reach_, reach);
  if (covers && low >= 0.0) return true;
  for (std::size_t k = 0; k < 3; ++k) refine_cut(ids[k], ids[(k + 1) % 3], 64.0 * slack);
  add_outline(ids, turn, viewer);
  return false;
}

// The outline of the part of the layer that is not behind the facet's plane.
void FacetView::add_outline(const std::array<std::uint32_t, 3>& ids, int turn, std::size_t viewer) {
  // From the lower vertex number on, whichever facet asks: the facets at an edge cut it at the very same point.
  const auto cut = [this](std::uint32_t a, std::uint32_t b) {
    const Seen &p = memo_[std::min(a, b)], &q = memo_[std::max(a, b)];
    const double t = p.height / (p.height - q.height);
    return Seen{p.u + t * (q.u - p.u), p.v + t * (q.v - p.v), 0.0, 0.0};
  };
  Seen enters{}, leaves{};
  bool is_cut = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t from = ids[k], to = ids[(k + 1) % 3];
    const Seen &a = memo_[from], &b = memo_[to];
    const std::uint64_t key = (std::uint64_t{std::min(from, to)} << 32U | std::max(from, to)) << 1U | viewer;
    const bool forward = from < to;
    const auto add = [&](const Seen& p, const Seen& q) {
      forward ? add_edge(key, p, q, turn) : add_edge(key, q, p, -turn);
    };
    if (a.height >= 0.0 && b.height >= 0.0) {
      add(a, b);
    } else if (a.height >= 0.0) {
      leaves = a.height == 0.0 ? a : cut(from, to);
      is_cut = true;
      if (a.height > 0.0) add(a, leaves);
    } else if (b.height >= 0.0) {
      enters = b.height == 0.0 ? b : cut(from, to);
      if (b.height > 0.0) add(enters, b);
    }
  }
  if (is_cut) add_edge(~next_cut_++, leaves, enters, turn);
}

void FacetView::add_edge(std::uint64_t key, const Seen& a, const Seen& b, int turns) {
  keyed_.push_back({key, a.u, a.v, b.u, b.v, turns});
}

// Edges between two layers go out, the rest become steps.
void FacetView::sum_edges() {
  std::sort(keyed_.begin(), keyed_.end(), [](const KeyedEdge& a, const KeyedEdge& b) { return a.key < b.key; });
  outline_.clear();
  for (std::size_t k = 0; k < keyed_.size();) {
    const KeyedEdge& e = keyed_[k];
    int turns = 0;
    for (; k < keyed_.size() && keyed_[k].key == e.key; ++k) turns += keyed_[k].turns;
    if (turns != 0) outline_.push_back({e.u0, e.v0, e.u1, e.v1, e.v0 > e.v1 ? turns : -turns});
  }
}

void FacetView::seen_fractions(std::vector<Estimate>& fraction) {
  const auto& nodes = tree_.nodes();
  for (std::uint32_t k = 0; k < nodes.size(); ++k) {
    if (!nodes[k].leaf) continue;
    for (Viewer& viewer : viewers_) {
      viewer.near_leaf.clear();
      viewer.projected.overlapping(tree_, viewer.projected.box_of_node(k), viewer.near_leaf);
    }
    for (std::uint32_t place = nodes[k].first; place < nodes[k].last; ++place)
      fraction[tree_.order()[place]] = seen_fraction(place);
  }
}

Estimate FacetView::seen_fraction(std::uint32_t place) {
  const std::uint32_t facet = tree_.order()[place];
  set_frame(facet);
  bool doubtful = false;
  for (const Viewer& viewer : viewers_) {
    const EdgeOn edge = edge_on(viewer.direction);
    if (edge == EdgeOn::exactly) return {};
    doubtful = doubtful || edge == EdgeOn::perhaps;
  }
  if (doubtful) return {0.0, 1.0};
  if (!one_side_faces_all()) return {};
  keyed_.clear();
  next_cut_ = 0;
  double error = 0.0;
  bool hidden = false;
  for (std::size_t k = 0; k < viewers_.size() && !hidden; ++k) {
    turn_frame(viewers_[k].direction);
    reach_ = std::max(frame_.e1.cwiseAbs().maxCoeff(), frame_.e2.cwiseAbs().maxCoeff());
    cut_error_ = 0.0;
    hidden = add_layers(place, k);
    const double rounding = 8.0 * unit_roundoff * std::max({1.0, reach_ * frame_.stretch, frame_.scale});
    error = std::max(error, rounding + cut_error_);
  }
  if (hidden) return {0.0, std::min(1.0, 16.0 * error)};
  sum_edges();
  const double fraction = 2.0 * count_.uncovered_area(outline_, error);
  const double bound = std::min(1.0, 4.0 * error * static_cast<double>(outline_.size() + 4));
  assert(fraction >= -bound && fraction <= 1.0 + bound);
  // What sticks out is rounding, within the bound.
  return {std::clamp(fraction, 0.0, 1.0), bound};
}

// All that stands before the facet toward one viewer. True: something covers it whole.
bool FacetView::add_layers(std::uint32_t place, std::size_t viewer) {
  const ProjectedTree& projected = viewers_[viewer].projected;
  const ProjectedBox& box = projected.box_of(place);
  const std::uint32_t facet = tree_.order()[place];
  for (const std::uint32_t other : viewers_[viewer].near_leaf) {
    const ProjectedBox& before = projected.box_of(other);
    if (other == place || before.near < box.far || !overlaps(before, box)) continue;
    if (hidden_by(tree_.order()[other], facet, viewer)) return true;
  }
  return false;
}

}  // namespace lrcs
