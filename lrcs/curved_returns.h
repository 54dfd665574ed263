#pragma once
#include <span>
#include <vector>

#include "base/estimate.h"
#include "lrcs/cross_section.h"
#include "lrcs/seen_parts.h"

namespace lrcs {

// What a curved facet returns to one pair of directions.
struct CurvedReturn {
  double returned = 0.0;   // integral of f_r cos_i cos_r over what is lit and seen of it [m^2/sr]
  double lower = 0.0;      // the same by the rule of lower degree
  double bound = 0.0;      // of returned: rounding, and what is not known of what is seen
  double lit_seen = 0.0;   // area lit and seen [m^2]
  double seen_area = 0.0;  // the same, projected toward the receiver [m^2]

  CurvedReturn& operator+=(const CurvedReturn& more) {
    returned += more.returned, lower += more.lower, bound += more.bound;
    lit_seen += more.lit_seen, seen_area += more.seen_area;
    return *this;
  }
  CurvedReturn& operator/=(double share) {
    returned /= share, lower /= share, bound /= share, lit_seen /= share, seen_area /= share;
    return *this;
  }
};

// Of all curved facets of a target, one a place of target.curved.facets().
// seen: the seen fraction of each flat facet. parts: what is seen of those seen in part (which it measures again, so is
// not const); those not among them, or all if it is null, count evenly by their fraction. A facet that the
// surface turns away on is cut where it does, and its fraction holds for the rest; where the flat facet is turned away
// but some of the surface is not, the fraction is that of its smooth neighbours that are not. error: see CurvedReturn;
// what remains of the curvature is told by returned - lower.
[[nodiscard]] std::vector<CurvedReturn> curved_returns(const Target& target, std::span<const Estimate> seen,
                                                       SeenParts* parts, const Vec3& to_transmitter,
                                                       const Vec3& to_receiver);

}  // namespace lrcs
