#include "lrcs/seen_parts.h"

#include <cmath>

namespace lrcs {

// Edges below the facet are not known, so what is below its side v = 0 is left out, and where an edge goes on there a
// line along the side takes over from it; what lies on the side is above it.
void BentOutlines::add_swapped(LayerEdge e, double error) {
  for (double* v : {&e.v0, &e.v1})
    if (std::abs(*v) <= error) *v = 0.0;
  if (e.v1 < 0.0) return;
  if (e.v0 < 0.0) {
    const double share = e.v0 / (e.v0 - e.v1);
    e.u0 += share * (e.u1 - e.u0), e.v0 = 0.0;
    e.bend0 += share * (e.bend1 - e.bend0);
    along_v_.push_back({0.0, e.u0, 0.0, 2.0, e.step});
  }
  const double bend0 = e.bends_in_v ? e.bend0 : 0.0, bend1 = e.bends_in_v ? e.bend1 : 0.0;
  // What is gained toward larger u is lost toward larger v where the edge rises to the right.
  along_v_.push_back({e.v0 + bend0, e.u0, e.v1 + bend1, e.u1, e.u1 > e.u0 ? -e.step : e.step});
}

// Layers stay the same along each row.
void BentOutlines::bend(std::span<const LayerEdge> straight, double error) {
  along_u_.clear();
  along_v_.clear();
  swept_ = 0.0;
  bool any_in_u = false, any_in_v = false;
  for (const LayerEdge& e : straight) {
    const bool bends = e.bend0 != 0.0 || e.bend1 != 0.0;
    any_in_u = any_in_u || (bends && !e.bends_in_v);
    any_in_v = any_in_v || (bends && e.bends_in_v);
    swept_ += e.swept;
  }
  if (any_in_u) {
    along_u_.assign(straight.begin(), straight.end());
    for (LayerEdge& e : along_u_)
      if (!e.bends_in_v) e.u0 += e.bend0, e.u1 += e.bend1;
  }
  if (any_in_v)
    for (const LayerEdge& e : straight) add_swapped(e, error);
}

void SeenParts::clear() {
  parts_.clear();
  edges_.clear();
}

void SeenParts::add(Part part, std::span<const LayerEdge> straight, const BentOutlines& bent) {
  const auto keep = [this](std::span<const LayerEdge> edges) {
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    return edges_.size();
  };
  part.straight = edges_.size();
  part.along_u = keep(straight);
  part.along_v = keep(bent.along_u());
  part.end = keep(bent.along_v());
  parts_.push_back(part);
}

// Changes along u and along v add up, to first order.
AreaMoments SeenParts::seen_within(const FacetPiece& piece, const Part& part) {
  const auto counted = [&](const FacetPiece& here, std::size_t first, std::size_t last) {
    in_piece_.clear();
    for (std::size_t k = first; k < last; ++k) in_piece_.push_back(here.within(edges_[k]));
    return here.on_facet(count_.uncovered(in_piece_, part.error / here.size, part.layers_at_left));
  };
  const bool moves_u = part.along_u < part.along_v, moves_v = part.along_v < part.end;
  if (!moves_v)
    return moves_u ? counted(piece, part.along_u, part.along_v) : counted(piece, part.straight, part.along_u);
  AreaMoments seen = counted(piece.swapped(), part.along_v, part.end).swapped();
  if (!moves_u) return seen;
  seen += counted(piece, part.along_u, part.along_v);
  seen -= counted(piece, part.straight, part.along_u);
  return seen;
}

}  // namespace lrcs
