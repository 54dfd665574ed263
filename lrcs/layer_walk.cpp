#include "lrcs/layer_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lrcs {

void LayerWalk::count(const std::vector<std::uint8_t>& wanted) {
  hidden_ = queries_ = 0;
  cuts_.clear();
  edges_.clear();
  if (!take_free(wanted)) return;
  grid_.fill(view_.edges(), view_.rounding());
  stamp_.assign(view_.edges().size(), 0);
  last_stamp_ = 0;
  cover_.find(surface_, view_);
  find_cuts();
  // Facets that nothing stands before are the best places to start, and those that no outline cuts better than others.
  const auto facets = static_cast<std::uint32_t>(states_.size());
  for (std::uint32_t f = 0; f < facets; ++f)
    if (states_[f].layers == 0 && nothing_before(f) && !free_.is_seen_whole(f)) begin_walk(f);
  for (const bool of_cut : {false, true})
    for (std::uint32_t f = 0; f < facets; ++f) {
      if (states_[f].layers != unknown || (states_[f].cut != none) != of_cut) continue;
      if (!of_cut && is_covered(f)) continue;
      begin_walk(f);
    }
}

// Takes the facets that are wanted and tells of those that nothing stands before. False: no others are left.
bool LayerWalk::take_free(const std::vector<std::uint8_t>& wanted) {
  free_.look_at(view_);
  states_.resize(wanted.size());
  bool any_left = false;
  for (std::uint32_t f = 0; f < wanted.size(); ++f) {
    const int layers = wanted[f] == 0 ? not_wanted : nothing_before(f) ? 0 : unknown;
    states_[f] = {layers, none};
    any_left = any_left || layers == unknown;
  }
  return any_left;
}

void LayerWalk::begin_walk(std::uint32_t facet) {
  if (states_[facet].layers == unknown && !start(facet))
    states_[facet].layers = failed;
  else if (!walk_from(facet) || !agrees_at_far_end())
    for (const std::uint32_t g : patch_) states_[g].layers = nothing_before(g) ? 0 : failed;
}

// Whole runs of facets lie where no outline runs.
void LayerWalk::find_cuts() {
  const auto& nodes = surface_.tree.nodes();
  const auto cut_if_wanted = [&](std::uint32_t f) {
    if (states_[f].layers != unknown) return;
    if (!is_covered(f) && cut(f)) is_hidden_by_many(f) ? keep_hidden(f) : keep_cut(f);
  };
  for (std::uint32_t k = 0; k < nodes.size();) {
    const FacetTree::Node& node = nodes[k];
    const Box3 box = surface_.tree.seen_box(node, view_.frame());
    const bool quiet = !grid_.any(grid_.cells(box.low.x(), box.high.x(), box.low.y(), box.high.y()));
    if (quiet) {
      const auto touched = surface_.contacts.among(node.first, node.last);
      for (const std::uint32_t f : touched) cut_if_wanted(f);
    } else if (node.leaf) {
      for (std::uint32_t f = node.first; f < node.last; ++f) cut_if_wanted(f);
    }
    k = quiet ? node.skip : k + 1;
  }
}

bool LayerWalk::is_covered(std::uint32_t facet) {
  if (!cover_.hides(view_, surface_.occluders.facets[facet])) return false;
  states_[facet].layers = hidden;
  ++hidden_;
  return true;
}

bool LayerWalk::cut(std::uint32_t facet) {
  const auto& ids = surface_.occluders.facets[facet];
  const SeenFacet seen(view_, ids);
  bool begun = false;
  const auto begin = [&] {
    if (!begun) cut_.begin(surface_, view_, facet);
    begun = true;
  };
  if (surface_.contacts.any(facet)) {
    begin();
    cut_.add_contacts();
  }
  const double rounding = view_.rounding();
  const auto cells =
      grid_.cells(seen.left - rounding, seen.right + rounding, seen.bottom - rounding, seen.top + rounding);
  if (!grid_.any(cells) || !grid_.any_before(cells, seen.far)) return begun && !cut_.empty();
  sift(seen, cells);
  if (!found_.empty()) sight_.look_at(seen, ids, rounding);
  ++last_stamp_;
  for (const std::uint32_t e : found_) {
    if (stamp_[e] == last_stamp_) continue;
    stamp_[e] = last_stamp_;
    const OutlineEdge& edge = view_.edges()[e];
    if (sight_.certainly_passes_by(edge)) continue;
    begin();
    cut_.add_outline(edge);
  }
  return begun && !cut_.empty();
}

// Fills found_ with the edges that may run over the facet, some perhaps more than once.
void LayerWalk::sift(const SeenFacet& seen, const EdgeGrid::Cells& cells) {
  found_.clear();
  const double rounding = view_.rounding(), reach = 2.0 * surface_.tree.reach();
  const std::size_t entries = grid_.entries(cells);
  constexpr std::size_t few = 24;
  if (entries <= few) {
    sieve_.look_at_box(seen, rounding, reach);
    for (int row = cells.y0; row <= cells.y1; ++row) {
      const auto [first, last] = grid_.run(row, cells.x0, cells.x1);
      sieve_.sift_boxes(grid_.ends(), first, last, found_);
    }
    return;
  }
  sieve_.look_at(seen, rounding, reach);
  // An edge stands in each cell that it passes: under a large facet it is quicker to look at each edge once.
  if (entries >= view_.edges().size()) return sieve_.sift(grid_.each(), 0, view_.edges().size(), found_);
  for (int row = cells.y0; row <= cells.y1; ++row) {
    const auto [first, last] = grid_.run(row, cells.x0, cells.x1);
    sieve_.sift(grid_.ends(), first, last, found_);
  }
}

void LayerWalk::keep_cut(std::uint32_t facet) {
  states_[facet].cut = static_cast<std::uint32_t>(cuts_.size());
  Cut kept{facet, static_cast<std::uint32_t>(edges_.size()), cut_.error(), {}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    kept.clear[k] = cut_.error() < hardly_known && cut_.port_is_clear(k);
    if (kept.clear[k]) kept.at_port[k] = cut_.layers_at_port(k);
  }
  cuts_.push_back(kept);
  edges_.insert(edges_.end(), cut_.edges().begin(), cut_.edges().end());
}

bool LayerWalk::is_hidden_by_many(std::uint32_t facet) {
  constexpr std::size_t many = 256;
  if (cut_.edges().size() < many) return false;
  const auto base = base_of_cut(facet);
  return base && count_.uncovered_area(cut_.edges(), cut_.error(), *base) == 0.0 && !count_.went_negative();
}

// One layer, no outlines, and no way over it; but the error is that of many.
void LayerWalk::keep_hidden(std::uint32_t facet) {
  states_[facet] = {1, static_cast<std::uint32_t>(cuts_.size())};
  const double error = cut_.error() * static_cast<double>(cut_.edges().size());
  cuts_.push_back({facet, static_cast<std::uint32_t>(edges_.size()), error, {}, {}});
}

LayerWalk::Outlines LayerWalk::outlines_over(std::uint32_t facet) const {
  const std::uint32_t k = states_[facet].cut;
  const std::size_t end = k + 1 < cuts_.size() ? cuts_[k + 1].first_edge : edges_.size();
  return {states_[facet].layers, std::span(edges_).subspan(cuts_[k].first_edge, end - cuts_[k].first_edge),
          cuts_[k].error};
}

bool LayerWalk::start(std::uint32_t facet) {
  if (states_[facet].cut != none) cut(facet);
  const auto layers = states_[facet].cut != none ? base_of_cut(facet) : count_layers(facet);
  if (layers) states_[facet].layers = *layers;
  return layers.has_value();
}

std::optional<int> LayerWalk::count_layers(std::uint32_t facet) {
  constexpr std::array<std::array<double, 2>, 4> places{{{0.31, 0.36}, {0.53, 0.23}, {0.17, 0.59}, {0.11, 0.13}}};
  const LayerQuery query(surface_.occluders, surface_.tree, view_.frame());
  const auto counted = [this](std::uint32_t f) { return view_.counts(f); };
  for (const auto& [u, v] : places) {
    ++queries_;
    if (const auto before = query.count(facet, u, v, counted)) return before->layers;
  }
  return std::nullopt;
}

// Of a long walk: a second count, on the last facet that no outline cuts.
bool LayerWalk::agrees_at_far_end() {
  constexpr std::size_t is_long = 64;
  if (patch_.size() < is_long) return true;
  const auto last = std::find_if(patch_.rbegin(), patch_.rend(), [this](auto f) { return states_[f].cut == none; });
  if (last == patch_.rend()) return true;
  const auto layers = count_layers(*last);
  return !layers || *layers == states_[*last].layers;
}

std::optional<int> LayerWalk::base_of_cut(std::uint32_t facet) {
  constexpr std::array<double, 6> heights{0.29, 0.13, 0.53, 0.05, 0.71, 0.4};
  const LayerQuery query(surface_.occluders, surface_.tree, view_.frame());
  const auto counted = [this](std::uint32_t f) { return view_.counts(f); };
  for (const double height : heights) {
    double u = 0.0, v = 0.0;
    if (!cut_.clear_place(height, u, v)) continue;
    ++queries_;
    if (const auto before = query.count(facet, u, v, counted)) return before->layers - cut_.layers_at(u, v);
  }
  return std::nullopt;
}

bool LayerWalk::walk_from(std::uint32_t facet) {
  patch_.assign(1, facet);
  bool agrees = true;
  for (std::size_t next = 0; next < patch_.size(); ++next) {
    const std::uint32_t f = patch_[next];
    const State here = states_[f];
    agrees = agrees && (here.cut != none || here.layers >= 0);
    const auto& across = surface_.edges.across(f);
    const int facing = view_.counts(f);
    for (std::size_t side = 0; side < 3; ++side) {
      if (across[side] == OccluderEdges::alone) continue;
      const std::uint32_t other = across[side] / 2;
      State& there = states_[other];
      // Only to the facet that goes on beyond the side: at a fold, both lie on one side of it.
      if (there.layers == not_wanted || there.layers == hidden ||
          view_.counts(other) != (across[side] % 2 == 0 ? facing : -facing))
        continue;
      int layers = here.layers;
      if (here.cut != none || there.cut != none) {
        const auto more = layers_across(f, side, other);
        if (!more) continue;
        layers += *more;
      }
      if (there.layers == unknown) {
        there.layers = layers;
        patch_.push_back(other);
      }
      agrees = agrees && there.layers == layers;
    }
  }
  return agrees;
}

std::optional<int> LayerWalk::layers_across(std::uint32_t facet, std::size_t side, std::uint32_t other) const {
  int layers = 0;
  if (states_[facet].cut != none) {
    const Cut& from = cuts_[states_[facet].cut];
    if (!from.clear[side]) return std::nullopt;
    layers += from.at_port[side];
  }
  if (states_[other].cut != none) {
    const Cut& to = cuts_[states_[other].cut];
    std::size_t its = 0;
    while (surface_.edges.across(other)[its] / 2 != facet ||
           surface_.edges.edge_of(other, its) != surface_.edges.edge_of(facet, side))
      ++its;
    if (!to.clear[its]) return std::nullopt;
    layers -= to.at_port[its];
  }
  return layers;
}

}  // namespace lrcs
