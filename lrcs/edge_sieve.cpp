#include "lrcs/edge_sieve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/wide_loop.h"

namespace lrcs {
namespace {

constexpr double unit = 0x1p-24;  // rounding of floats

using Floats = const float* __restrict;

// out[k] is 0 for edges that certainly have nothing over the facet and in front of it. Comparisons with what is not a
// number rule out nothing.
LRCS_WIDE void look_at_edges(std::size_t count, Floats ax, Floats ay, Floats az, Floats bx, Floats by, Floats bz,
                             const EdgeSieve::Facet facet, std::int32_t* __restrict out) {
  const EdgeSieve::Facet f = facet;
  for (std::size_t first = 0; first < count; first += EdgeEnds::lanes)
    for (std::size_t k = first; k < first + EdgeEnds::lanes; ++k) {
      const float ua = f.u_x * ax[k] + f.u_y * ay[k] + f.u_0, ub = f.u_x * bx[k] + f.u_y * by[k] + f.u_0;
      const float va = f.v_x * ax[k] + f.v_y * ay[k] + f.v_0, vb = f.v_x * bx[k] + f.v_y * by[k] + f.v_0;
      const float ha = f.h_x * ax[k] + f.h_y * ay[k] + f.h_0 + az[k],
                  hb = f.h_x * bx[k] + f.h_y * by[k] + f.h_0 + bz[k];
      const int left = (ax[k] < f.left) & (bx[k] < f.left), right = (ax[k] > f.right) & (bx[k] > f.right);
      const int below = (ay[k] < f.bottom) & (by[k] < f.bottom), above = (ay[k] > f.top) & (by[k] > f.top);
      const int behind = ((az[k] < f.far) & (bz[k] < f.far)) | ((ha < -f.height_slack) & (hb < -f.height_slack));
      const int beyond = ((ua < -f.slack) & (ub < -f.slack)) | ((va < -f.slack) & (vb < -f.slack)) |
                         ((ua + va > 1.0F + 2.0F * f.slack) & (ub + vb > 1.0F + 2.0F * f.slack));
      // Which side of the edge's line the three corners are on.
      const float at0 = ua * vb - ub * va, at1 = at0 - (vb - va), at2 = at0 + (ub - ua);
      const float doubt = 2.0F * f.slack * (std::abs(ua) + std::abs(ub) + std::abs(va) + std::abs(vb) + 2.0F);
      const int beside =
          ((at0 > doubt) & (at1 > doubt) & (at2 > doubt)) | ((at0 < -doubt) & (at1 < -doubt) & (at2 < -doubt));
      out[k] = (left | right | below | above | behind | beyond | beside) ^ 1;
    }
}

}  // namespace

void EdgeEnds::resize(std::size_t edges) {
  for (auto* coordinate : {&low_x, &low_y, &low_z, &high_x, &high_y, &high_z}) coordinate->resize(edges + lanes);
  edge.resize(edges);
}

void EdgeEnds::put(std::size_t place, const OutlineEdge& e, std::uint32_t number) {
  low_x[place] = static_cast<float>(e.at_low.x());
  low_y[place] = static_cast<float>(e.at_low.y());
  low_z[place] = static_cast<float>(e.at_low.z());
  high_x[place] = static_cast<float>(e.at_high.x());
  high_y[place] = static_cast<float>(e.at_high.y());
  high_z[place] = static_cast<float>(e.at_high.z());
  edge[place] = number;
}

void EdgeSieve::look_at_box(const SeenFacet& facet, double rounding, double reach) {
  // Rounding of the box itself, and of the edges' ends.
  const double margin = 4.0 * unit * reach + rounding;
  facet_.left = static_cast<float>(facet.left - margin);
  facet_.right = static_cast<float>(facet.right + margin);
  facet_.bottom = static_cast<float>(facet.bottom - margin);
  facet_.top = static_cast<float>(facet.top + margin);
  facet_.far = static_cast<float>(facet.far - margin);
}

// Errors: with u = 2^-24, coordinates are off by u reach, coefficients by u of themselves, and three products and sums
// by a few u of the largest term: below 8 u of the sum of terms; twice that is taken. Those of the doubles, which
// FacetSight derives, are added.
void EdgeSieve::look_at(const SeenFacet& facet, double rounding, double reach) {
  constexpr double roundings = 16.0 * unit;
  look_at_box(facet, rounding, reach);
  const auto own = facet.own_coordinates();
  const double u_0 = -own.u_x * facet.x[0] - own.u_y * facet.y[0], v_0 = -own.v_x * facet.x[0] - own.v_y * facet.y[0];
  const double z_u = facet.z[1] - facet.z[0], z_v = facet.z[2] - facet.z[0];
  const double h_x = -(z_u * own.u_x + z_v * own.v_x), h_y = -(z_u * own.u_y + z_v * own.v_y);
  const double h_0 = -(facet.z[0] + z_u * u_0 + z_v * v_0);
  const double of_u = (std::abs(own.u_x) + std::abs(own.u_y)) * reach + std::abs(u_0);
  const double of_v = (std::abs(own.v_x) + std::abs(own.v_y)) * reach + std::abs(v_0);
  const double slopes = std::abs(z_u) + std::abs(z_v);
  const double doubles = 8.0 * rounding * facet.sides() / std::abs(facet.area()) * (1.0 + of_u + of_v);
  const double slack = roundings * std::max(of_u, of_v) + 2.0 * doubles;
  const double height_slack = roundings * ((std::abs(h_x) + std::abs(h_y) + 1.0) * reach + std::abs(h_0)) +
                              0x1p-48 * (reach + slopes * (of_u + of_v)) + 4.0 * rounding * (1.0 + of_u + of_v) +
                              4.0 * doubles * slopes;
  // Where products of the slack are not small beside it, nothing is ruled out but by boxes.
  constexpr double hardly_known = 0x1p-3;
  const auto stated = [&](double error) {
    return slack < hardly_known ? static_cast<float>(error * (1.0 + 2.0 * unit))
                                : std::numeric_limits<float>::infinity();
  };
  facet_.u_x = static_cast<float>(own.u_x), facet_.u_y = static_cast<float>(own.u_y);
  facet_.v_x = static_cast<float>(own.v_x), facet_.v_y = static_cast<float>(own.v_y);
  facet_.u_0 = static_cast<float>(u_0), facet_.v_0 = static_cast<float>(v_0);
  facet_.h_x = static_cast<float>(h_x), facet_.h_y = static_cast<float>(h_y), facet_.h_0 = static_cast<float>(h_0);
  facet_.slack = stated(slack);
  facet_.height_slack = stated(height_slack);
}

void EdgeSieve::sift(const EdgeEnds& ends, std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
  const std::size_t count = last - first;
  may_matter_.resize(std::max(may_matter_.size(), count + EdgeEnds::lanes));
  look_at_edges(count, &ends.low_x[first], &ends.low_y[first], &ends.low_z[first], &ends.high_x[first],
                &ends.high_y[first], &ends.high_z[first], facet_, may_matter_.data());
  for (std::size_t k = 0; k < count; ++k)
    if (may_matter_[k] != 0) found.push_back(ends.edge[first + k]);
}

void EdgeSieve::sift_boxes(const EdgeEnds& ends, std::size_t first, std::size_t last,
                           std::vector<std::uint32_t>& found) const {
  for (std::size_t k = first; k < last; ++k) {
    const auto [x0, x1] = std::minmax(ends.low_x[k], ends.high_x[k]);
    const auto [y0, y1] = std::minmax(ends.low_y[k], ends.high_y[k]);
    const int apart = (x1 < facet_.left ? 1 : 0) | (x0 > facet_.right ? 1 : 0) | (y1 < facet_.bottom ? 1 : 0) |
                      (y0 > facet_.top ? 1 : 0) | (std::max(ends.low_z[k], ends.high_z[k]) < facet_.far ? 1 : 0);
    if (apart == 0) found.push_back(ends.edge[k]);
  }
}

}  // namespace lrcs
