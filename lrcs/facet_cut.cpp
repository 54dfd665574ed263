#include "lrcs/facet_cut.h"

#include <algorithm>
#include <cmath>

#include "lrcs/facet_rise.h"
#include "lrcs/facet_view.h"
#include "lrcs/unit_triangle.h"

namespace lrcs {
namespace {

// Where on an edge its port lies, from the lower vertex on: nowhere special.
constexpr double port_share = 0.43819660112501053;

double u_at(const LayerEdge& e, double v) {
  return e.u0 + (e.u1 - e.u0) * ((v - e.v0) / (e.v1 - e.v0));
}

bool spans(const LayerEdge& e, double v) {
  return std::min(e.v0, e.v1) <= v && v < std::max(e.v0, e.v1);
}

// The part of a piece that lies over the facet, as shares of it.
struct Over {
  double from = 0.0, to = 1.0;

  explicit Over(const LayerEdge& e) { keep(e.u0, e.u1), keep(e.v0, e.v1), keep(1.0 - e.u0 - e.v0, 1.0 - e.u1 - e.v1); }
  void keep(double a, double b) {
    if (a == b) return;
    const double zero = a / (a - b);
    if (a < b)
      from = std::max(from, zero);
    else
      to = std::min(to, zero);
  }
};

}  // namespace

void FacetCut::begin(const Surface& surface, const ViewOutline& view, std::uint32_t facet) {
  surface_ = &surface;
  view_ = &view;
  facet_ = facet;
  frame_ = FacetFrame(surface.occluders, facet);
  frame_.turn(view.frame().toward);
  has_flat_ = false;
  error_ = std::max(frame_.rounding(frame_.own_reach()), frame_.scale_error());
  near_ = false;
  segments_.clear();
  edges_.clear();
  const auto& ids = surface.occluders.facets[facet];
  const auto share = [&](std::size_t k) { return ids[k] < ids[(k + 1) % 3] ? port_share : 1.0 - port_share; };
  ports_ = {{{share(0), 0.0}, {1.0 - share(1), share(1)}, {0.0, 1.0 - share(2)}}};
  clear_ = {true, true, true};
}

void FacetCut::add_outline(const OutlineEdge& edge) {
  const int corner_a = frame_.corner(edge.low), corner_b = frame_.corner(edge.high);
  if (corner_a >= 0 && corner_b >= 0) return;
  FacetPoint a = frame_.at_vertex(edge.low), b = frame_.at_vertex(edge.high);
  double slack = frame_.rounding(std::max(frame_.reach(edge.low), frame_.reach(edge.high)));
  if ((sides_beyond(a, corner_a, slack) & sides_beyond(b, corner_b, slack)) != 0) return;
  if (line_passes_by(a, corner_a, b, corner_b, slack)) return;
  if (!a.sign_is_certain()) frame_.refine(a, edge.low);
  if (!b.sign_is_certain()) frame_.refine(b, edge.high);
  if (a.height <= 0.0 && b.height <= 0.0) return;
  settle(a, edge.low);
  settle(b, edge.high);
  const std::size_t first = edges_.size();
  add_between(edge, a, corner_a, b, corner_b, slack);
  if (!surface_->occluders.corner_normals.empty()) bend(edge, a, b, first);
}

void FacetCut::add_between(const OutlineEdge& edge, const FacetPoint& a, int corner_a, const FacetPoint& b,
                           int corner_b, double slack) {
  if (a.height < 0.0 || b.height < 0.0) {
    double error = 0.0;
    const FacetPoint cut = flat().passage(edge.low, edge.high, error);
    slack = std::max(slack, error);
    if (b.height < 0.0)
      add(a, corner_a, cut, -1, edge.gain, slack);
    else
      add(cut, -1, b, corner_b, edge.gain, slack);
    return;
  }
  add(a, corner_a, b, corner_b, edge.gain, slack);
}

// Of the pieces from `first` on, all of one edge: in u or v only, so that layers stay the same at every height. The
// outline lies beside the edge, and the facet's own surface rises over it: seen askew, what lies under the outline is
// another place of it.
void FacetCut::bend(const OutlineEdge& edge, const FacetPoint& low, const FacetPoint& high, std::size_t first) {
  const double run = high.u - low.u, rise = high.v - low.v;
  const bool in_v = std::abs(run) > std::abs(rise);
  const double slope = in_v ? rise / run : run / rise;
  if (!std::isfinite(slope)) return;
  const auto beside = [&](const Vec3& by) {
    const Eigen::Vector2d step = frame_.step(by);
    return in_v ? step.y() - slope * step.x() : step.x() - slope * step.y();
  };
  const double at_low = beside(edge.bend.at_low), at_high = beside(edge.bend.at_high);
  const FacetRise own(surface_->occluders, facet_);
  for (std::size_t k = first; k < edges_.size(); ++k) {
    LayerEdge& piece = edges_[k];
    // Not the lines that stand for what lies left of the facet.
    if (piece.u0 == 0.0 && piece.u1 == 0.0) continue;
    const Over over(piece);
    if (!(over.from < over.to)) continue;
    const auto at = [&](double share) {
      const double u = piece.u0 + share * (piece.u1 - piece.u0), v = piece.v0 + share * (piece.v1 - piece.v0);
      const double along = in_v ? (u - low.u) / run : (v - low.v) / rise;
      return at_low + along * (at_high - at_low) - beside(own.at(u, v));
    };
    // The line with the same area beside the piece, from where it comes over the facet to where it leaves it.
    const double begin = at(over.from), middle = at(0.5 * (over.from + over.to)), end = at(over.to);
    const double more = 2.0 / 3.0 * (middle - 0.5 * (begin + end)), slant = (end - begin) / (over.to - over.from);
    piece.bend0 = begin + more - over.from * slant;
    piece.bend1 = piece.bend0 + slant;
    piece.bends_in_v = in_v;
    const double along = in_v ? piece.u1 - piece.u0 : piece.v1 - piece.v0;
    piece.swept =
        (over.to - over.from) * std::abs(along) * (std::abs(begin) + 4.0 * std::abs(middle) + std::abs(end)) / 6.0;
  }
}

const FacetFrame& FacetCut::flat() {
  if (!has_flat_) {
    flat_ = FacetFrame(surface_->occluders, facet_);
    flat_.turn_to_front();
    has_flat_ = true;
  }
  return flat_;
}

void FacetCut::settle(FacetPoint& point, std::uint32_t vertex) {
  if (point.height != 0.0) return;
  const FacetPoint there = flat().at_vertex(vertex);
  point.u = there.u;
  point.v = there.v;
}

void FacetCut::add_contacts() {
  if (!surface_->contacts.any(facet_)) return;
  near_ = true;
  const auto of = surface_->contacts.of(facet_);
  if (!of.coplanar.empty()) clear_ = {false, false, false};
  for (const auto& passage : of.passages) {
    const int counted = view_->counts(passage.facet);
    // The layer lies left of the line from where its winding goes below to where it comes up, in the view.
    double error_leaves = 0.0, error_enters = 0.0;
    const FacetPoint leaves = flat().passage(passage.leaves.low, passage.leaves.high, error_leaves);
    const FacetPoint enters = flat().passage(passage.enters.low, passage.enters.high, error_enters);
    add(leaves, corner(passage.leaves), enters, corner(passage.enters), frame_.facing() > 0.0 ? -counted : counted,
        std::max(error_leaves, error_enters));
  }
  for (const auto& lying : of.edges) {
    const auto& edge = surface_->edges.edges()[lying.edge];
    const double reach = std::max(flat().reach(edge.low), flat().reach(edge.high));
    add(flat().at_vertex(edge.low), frame_.corner(edge.low), flat().at_vertex(edge.high), frame_.corner(edge.high),
        gain_of(lying, surface_->contacts.sides(lying)), flat().rounding(reach));
  }
}

// Facets on the right of an edge in the facet's plane less those on the left: those in front, and those in the plane
// that come first.
int FacetCut::gain_of(const Contacts::LyingEdge& edge, const std::int8_t* sides) const {
  int gain = 0;
  for (const FacetAtEdge& use : surface_->edges.facets_at(edge.edge)) {
    const double side = frame_.facing() * *sides++;
    const int counted = view_->counts(use.facet);
    const bool before = side > 0.0 || (side == 0.0 && ranks_before(surface_->occluders, use.facet, counted > 0, facet_,
                                                                   frame_.facing() > 0.0));
    if (before) gain += use.rising ? -counted : counted;
  }
  return gain;
}

// `gain`: layers on the right less those on the left, looking from a to b in the view.
void FacetCut::add(const FacetPoint& a, int corner_a, const FacetPoint& b, int corner_b, int gain, double slack) {
  if ((sides_beyond(a, corner_a, slack) & sides_beyond(b, corner_b, slack)) != 0) return;
  near_ = true;
  close_ports(a, b, slack);
  segments_.push_back({a, b, slack});
  error_ = std::max(error_, slack);
  // Seen from behind, left and right change places.
  if (gain != 0) push(a, b, frame_.facing() > 0.0 ? gain : -gain);
}

void FacetCut::close_ports(const FacetPoint& a, const FacetPoint& b, double slack) {
  const double clearance = 16.0 * slack;
  for (std::size_t k = 0; k < 3; ++k)
    if (squared_distance(ports_[k][0], ports_[k][1], a, b) <= clearance * clearance) clear_[k] = false;
}

// `gain`: toward the right looking from a to b, u to the right and v up.
void FacetCut::push(FacetPoint a, FacetPoint b, int gain) {
  if (a.v > b.v) {
    std::swap(a, b);
    gain = -gain;
  }
  // What lies on the side u = 0 itself counts as left of it.
  const bool from_left = a.u <= 0.0, to_left = b.u <= 0.0;
  if (from_left && to_left) return;
  if (from_left || to_left) {
    const double t = a.u / (a.u - b.u);
    const double v = std::clamp(a.v + t * (b.v - a.v), a.v, b.v);
    // Going up, an outline that leaves to the left has its gain beside the facet from there on.
    edges_.push_back({0.0, v, 0.0, 2.0, to_left ? gain : -gain});
    (to_left ? b : a) = {0.0, v, 0.0, 0.0};
  }
  edges_.push_back({a.u, a.v, b.u, b.v, gain});
}

int FacetCut::layers_at(double u, double v) const {
  int layers = 0;
  for (const LayerEdge& e : edges_)
    if (spans(e, v) && u_at(e, v) <= u) layers += e.step;
  return layers;
}

bool FacetCut::clear_place(double height, double& u, double& v) {
  crossings_.assign({0.0, 1.0 - height});
  for (const LayerEdge& e : edges_)
    if (spans(e, height)) crossings_.push_back(std::clamp(u_at(e, height), 0.0, 1.0 - height));
  std::sort(crossings_.begin(), crossings_.end());
  double widest = 0.0;
  for (std::size_t k = 0; k + 1 < crossings_.size(); ++k)
    if (crossings_[k + 1] - crossings_[k] > widest) {
      widest = crossings_[k + 1] - crossings_[k];
      u = 0.5 * (crossings_[k] + crossings_[k + 1]);
    }
  v = height;
  return widest > 0.0 && std::all_of(segments_.begin(), segments_.end(), [&](const Segment& s) {
           return squared_distance(u, v, s.a, s.b) > 256.0 * s.slack * s.slack;
         });
}

}  // namespace lrcs
