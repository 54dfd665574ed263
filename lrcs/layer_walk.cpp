#include "lrcs/layer_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lrcs {

void LayerWalk::count(const std::vector<std::uint8_t>& wanted) {
  grid_.fill(view_.edges(), view_.x(), view_.y(), view_.rounding());
  stamp_.assign(view_.edges().size(), 0);
  last_stamp_ = 0;
  cut_of_.assign(surface_.occluders.size(), none);
  layers_.assign(surface_.occluders.size(), unknown);
  queries_ = 0;
  cut_facets(wanted);
  // Facets that no outline cuts are the better places to start.
  const auto facets = static_cast<std::uint32_t>(surface_.occluders.size());
  for (const bool of_cut : {false, true})
    for (std::uint32_t f = 0; f < facets; ++f) {
      if (wanted[f] == 0 || layers_[f] != unknown || (cut_of_[f] != none) != of_cut) continue;
      if (!start(f))
        layers_[f] = failed;
      else if (!walk_from(f, wanted))
        for (const std::uint32_t g : patch_) layers_[g] = failed;
    }
}

void LayerWalk::cut_facets(const std::vector<std::uint8_t>& wanted) {
  cuts_.clear();
  edges_.clear();
  for (std::uint32_t f = 0; f < surface_.occluders.size(); ++f)
    if (wanted[f] != 0 && cut(f)) keep_cut(f);
}

bool LayerWalk::cut(std::uint32_t facet) {
  const auto& ids = surface_.occluders.facets[facet];
  const double* const x = view_.x();
  const double* const y = view_.y();
  const double* const z = view_.z();
  const auto [x0, x1] = std::minmax({x[ids[0]], x[ids[1]], x[ids[2]]});
  const auto [y0, y1] = std::minmax({y[ids[0]], y[ids[1]], y[ids[2]]});
  const double far = std::min({z[ids[0]], z[ids[1]], z[ids[2]]}) - view_.rounding();
  const bool touched = surface_.contacts.any(facet);
  bool begun = false;
  const auto begin = [&] {
    if (!begun) cut_.begin(surface_, view_, facet);
    begun = true;
  };
  if (touched) {
    begin();
    cut_.add_contacts();
  }
  const auto cells =
      grid_.cells(x0 - view_.rounding(), x1 + view_.rounding(), y0 - view_.rounding(), y1 + view_.rounding());
  ++last_stamp_;
  for (int row = cells.y0; row <= cells.y1; ++row)
    for (int column = cells.x0; column <= cells.x1; ++column) {
      if (grid_.near(column, row) < far) continue;
      for (const std::uint32_t e : grid_.edges_in(column, row)) {
        if (stamp_[e] == last_stamp_) continue;
        stamp_[e] = last_stamp_;
        const OutlineEdge& edge = view_.edges()[e];
        // The edges' boxes are widened by the rounding of both.
        if (edge.near < far || edge.x0 > x1 || edge.x1 < x0 || edge.y0 > y1 || edge.y1 < y0) continue;
        begin();
        cut_.add_outline(edge);
      }
    }
  return begun && !cut_.empty();
}

void LayerWalk::keep_cut(std::uint32_t facet) {
  cut_of_[facet] = static_cast<std::uint32_t>(cuts_.size());
  Cut kept{facet, static_cast<std::uint32_t>(edges_.size()), cut_.error(), {}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    kept.clear[k] = cut_.port_is_clear(k);
    if (kept.clear[k]) kept.at_port[k] = cut_.layers_at_port(k);
  }
  cuts_.push_back(kept);
  edges_.insert(edges_.end(), cut_.edges().begin(), cut_.edges().end());
}

LayerWalk::Outlines LayerWalk::outlines_over(std::uint32_t facet) const {
  const std::uint32_t k = cut_of_[facet];
  const std::size_t end = k + 1 < cuts_.size() ? cuts_[k + 1].first_edge : edges_.size();
  return {layers_[facet], std::span(edges_).subspan(cuts_[k].first_edge, end - cuts_[k].first_edge), cuts_[k].error};
}

bool LayerWalk::start(std::uint32_t facet) {
  if (cut_of_[facet] != none) return start_in_cut(facet);
  constexpr std::array<std::array<double, 2>, 4> places{{{0.31, 0.36}, {0.53, 0.23}, {0.17, 0.59}, {0.11, 0.13}}};
  const FacetFrame frame(surface_.occluders, facet);
  const LayerQuery query(surface_.occluders, surface_.tree, view_.frame());
  const auto counted = [this](std::uint32_t f) { return int{view_.counted()[f]}; };
  for (const auto& [u, v] : places) {
    ++queries_;
    if (const auto before = query.count(facet, frame.place(u, v), counted)) {
      layers_[facet] = before->layers;
      return true;
    }
  }
  return false;
}

bool LayerWalk::start_in_cut(std::uint32_t facet) {
  constexpr std::array<double, 6> heights{0.29, 0.13, 0.53, 0.05, 0.71, 0.4};
  cut(facet);
  const LayerQuery query(surface_.occluders, surface_.tree, view_.frame());
  const auto counted = [this](std::uint32_t f) { return int{view_.counted()[f]}; };
  for (const double height : heights) {
    double u = 0.0, v = 0.0;
    if (!cut_.clear_place(height, u, v)) continue;
    ++queries_;
    if (const auto before = query.count(facet, cut_.frame().place(u, v), counted)) {
      layers_[facet] = before->layers - cut_.layers_at(u, v);
      return true;
    }
  }
  return false;
}

bool LayerWalk::walk_from(std::uint32_t facet, const std::vector<std::uint8_t>& wanted) {
  patch_.assign(1, facet);
  bool agrees = true;
  for (std::size_t next = 0; next < patch_.size(); ++next) {
    const std::uint32_t f = patch_[next];
    agrees = agrees && (cut_of_[f] != none || layers_[f] >= 0);
    for (std::size_t side = 0; side < 3; ++side) agrees = step(f, side, wanted) && agrees;
  }
  return agrees;
}

bool LayerWalk::step(std::uint32_t facet, std::size_t side, const std::vector<std::uint8_t>& wanted) {
  const std::uint32_t e = surface_.edges.edge_of(facet, side);
  if (!view_.is_ordinary(e)) return true;
  const auto& use = surface_.edges.edges()[e].use;
  const std::uint32_t other = use[0] / 2 == facet ? use[1] / 2 : use[0] / 2;
  if (wanted[other] == 0) return true;
  int layers = layers_[facet];
  if (cut_of_[facet] != none) {
    const Cut& from = cuts_[cut_of_[facet]];
    if (!from.clear[side]) return true;
    layers += from.at_port[side];
  }
  if (cut_of_[other] != none) {
    const Cut& to = cuts_[cut_of_[other]];
    std::size_t its = 0;
    while (surface_.edges.edge_of(other, its) != e) ++its;
    if (!to.clear[its]) return true;
    layers -= to.at_port[its];
  }
  if (layers_[other] == unknown) {
    layers_[other] = layers;
    patch_.push_back(other);
  }
  return layers_[other] == layers;
}

}  // namespace lrcs
