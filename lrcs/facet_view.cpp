#include "lrcs/facet_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "lrcs/unit_triangle.h"

namespace lrcs {
namespace {

double turn_of(double au, double av, double bu, double bv, double cu, double cv) {
  return (bu - au) * (cv - av) - (bv - av) * (cu - au);
}

}  // namespace

void FacetView::look_along(const std::vector<Vec3>& directions) {
  viewers_.clear();
  for (Seen& s : memo_) s.stamp = 0;
  stamp_ = 0;
  for (const Vec3& d : directions) viewers_.emplace_back(d, occluders_.centre);
}

FacetView::Seen& FacetView::seen(std::uint32_t vertex) {
  Seen& s = memo_[vertex];
  if (s.stamp != stamp_) s = {frame_.at_vertex(vertex), stamp_};
  return s;
}

void FacetView::refine_cut(std::uint32_t a, std::uint32_t b, double slack) {
  Seen &p = memo_[a], &q = memo_[b];
  const bool passes = (p.height > 0.0 && q.height < 0.0) || (p.height < 0.0 && q.height > 0.0);
  if (!passes) return;
  if (passage_error(p, q) > slack) {
    frame_.refine(p, a);
    frame_.refine(q, b);
  }
  cut_error_ = std::max(cut_error_, passage_error(p, q));
}

// Adds the layer that `blocker` makes over the facet. True: it covers all of it.
bool FacetView::hidden_by(std::uint32_t blocker, std::uint32_t facet, std::size_t viewer) {
  const auto& ids = occluders_.facets[blocker];
  const std::array<Seen*, 3> p{&seen(ids[0]), &seen(ids[1]), &seen(ids[2])};
  const auto certainly_behind = [](const Seen* s) { return s->sign_is_certain() && s->height <= 0.0; };
  if (std::all_of(p.begin(), p.end(), certainly_behind) &&
      (p[0]->height < 0.0 || p[1]->height < 0.0 || p[2]->height < 0.0))
    return false;

  double reach = 0.0;
  for (const auto id : ids) reach = std::max(reach, frame_.reach(id));
  const double slack = frame_.rounding(reach);
  unsigned beyond = 7;
  for (std::size_t k = 0; k < 3; ++k) beyond &= sides_beyond(*p[k], frame_.corner(ids[k]), slack);
  if (beyond != 0) return false;
  // Less overlap than the coordinates' rounding error is no overlap, within the bound that this reach gives.
  reach_ = std::max(reach_, reach);
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
    if (!p[k]->sign_is_certain()) frame_.refine(*p[k], ids[k]);
  const auto [low, high] = std::minmax({p[0]->height, p[1]->height, p[2]->height});
  if (low == 0.0 && high == 0.0) {
    const bool blocker_front = occluders_.cross[blocker].dot(viewers_[viewer].toward) > 0.0;
    if (!ranks_before(occluders_, blocker, blocker_front, facet, frame_.facing() > 0.0)) return false;
  } else if (high <= 0.0) {
    return false;
  }
  if (covers && low >= 0.0) return true;
  for (std::size_t k = 0; k < 3; ++k) refine_cut(ids[k], ids[(k + 1) % 3], 64.0 * slack);
  add_outline(ids, turn, viewer);
  return false;
}

// The outline of the part of the layer that is not behind the facet's plane.
void FacetView::add_outline(const std::array<std::uint32_t, 3>& ids, int turn, std::size_t viewer) {
  // From the lower vertex number on, whichever facet asks: the facets at an edge cut it at the very same point.
  const auto cut = [this](std::uint32_t a, std::uint32_t b) {
    return plane_passage(memo_[std::min(a, b)], memo_[std::max(a, b)]);
  };
  FacetPoint enters, leaves;
  bool is_cut = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t from = ids[k], to = ids[(k + 1) % 3];
    const Seen &a = memo_[from], &b = memo_[to];
    const std::uint64_t key = (std::uint64_t{std::min(from, to)} << 32U | std::max(from, to)) << 1U | viewer;
    const bool forward = from < to;
    const auto add = [&](const FacetPoint& p, const FacetPoint& q) {
      forward ? add_edge(key, p, q, turn) : add_edge(key, q, p, -turn);
    };
    if (a.height >= 0.0 && b.height >= 0.0) {
      add(a, b);
    } else if (a.height >= 0.0) {
      leaves = a.height == 0.0 ? FacetPoint(a) : cut(from, to);
      is_cut = true;
      if (a.height > 0.0) add(a, leaves);
    } else if (b.height >= 0.0) {
      enters = b.height == 0.0 ? FacetPoint(b) : cut(from, to);
      if (b.height > 0.0) add(enters, b);
    }
  }
  if (is_cut) add_edge(~next_cut_++, leaves, enters, turn);
}

void FacetView::add_edge(std::uint64_t key, const FacetPoint& a, const FacetPoint& b, int turns) {
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

Estimate FacetView::seen_fraction(std::uint32_t facet) {
  const Vec3& cross = occluders_.cross[facet];
  bool doubtful = false;
  for (const ViewFrame& viewer : viewers_) {
    const auto edge = FacetFrame::edge_on(cross, viewer.toward);
    if (edge == FacetFrame::EdgeOn::exactly) return {};
    doubtful = doubtful || edge == FacetFrame::EdgeOn::perhaps;
  }
  if (doubtful) return {0.0, 1.0};
  if ((cross.dot(viewers_.front().toward) > 0.0) != (cross.dot(viewers_.back().toward) > 0.0)) return {};
  frame_ = FacetFrame(occluders_, facet);
  keyed_.clear();
  next_cut_ = 0;
  double error = 0.0;
  bool hidden = false;
  for (std::size_t k = 0; k < viewers_.size() && !hidden; ++k) {
    frame_.turn(viewers_[k].toward);
    ++stamp_;
    reach_ = frame_.own_reach();
    cut_error_ = 0.0;
    hidden = add_layers(facet, k);
    error = std::max(error, std::max(frame_.rounding(reach_), frame_.scale_error()) + cut_error_);
  }
  if (hidden) return {0.0, std::min(1.0, 16.0 * error)};
  sum_edges();
  const double fraction = 2.0 * count_.uncovered_area(outline_, error);
  const double bound = 4.0 * error * static_cast<double>(outline_.size() + 4);
  if (!(bound < 1.0)) return {0.0, 1.0};  // edge-on as far as rounding can tell
  assert(fraction >= -bound && fraction <= 1.0 + bound);
  // What sticks out is rounding, within the bound.
  return {std::clamp(fraction, 0.0, 1.0), bound};
}

// All that stands before the facet toward one viewer. True: something covers it whole.
bool FacetView::add_layers(std::uint32_t facet, std::size_t viewer) {
  const ViewFrame& view = viewers_[viewer];
  const auto box_of = [&](std::uint32_t f) {
    const auto& ids = occluders_.facets[f];
    const Vec3 a = view.at(occluders_.positions[ids[0]]), b = view.at(occluders_.positions[ids[1]]),
               c = view.at(occluders_.positions[ids[2]]);
    return Box3{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
  };
  // Three products and their sum, of lengths up to the reach: below 16 roundings, on either side.
  const Vec3 rounding = Vec3::Constant(32.0 * unit_roundoff * tree_.reach());
  Box3 box = box_of(facet);
  box = {box.low - rounding, box.high + rounding};
  before_.clear();
  tree_.before(view, box, before_);
  for (const std::uint32_t other : before_) {
    if (other == facet) continue;
    const Box3 its = box_of(other);
    const bool apart = its.low.x() > box.high.x() || its.high.x() < box.low.x() || its.low.y() > box.high.y() ||
                       its.high.y() < box.low.y() || its.high.z() < box.low.z();
    if (!apart && hidden_by(other, facet, viewer)) return true;
  }
  return false;
}

}  // namespace lrcs
