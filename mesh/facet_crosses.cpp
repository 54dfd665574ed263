#include "mesh/facet_crosses.h"

#include <algorithm>
#include <cmath>

#include "base/expansion.h"
#include "base/wide_loop.h"
#include "mesh/facet_mesh.h"
#include "mesh/product_difference.h"

namespace lrcs {
namespace {

constexpr std::size_t block = 64;
using Lane = std::array<double, block>;

// Corners a, b, c of the facets of a block and, of what is found, the cross products and which of them are not sure.
struct Block {
  std::array<std::array<Lane, 3>, 3> corner;
  std::array<Lane, 3> cross;
  std::array<Lane, 3> unsure;  // 0: sure
};

struct Halves {
  double high, low;
};

// law: exact for |a| below 2^990.
inline Halves halves_of(double a) {
  const double scaled = 134217729.0 * a;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

// law: the same as product_of() unless parts of it underflow.
inline Unrounded split_product(double a, double b) {
  const double value = a * b;
  const Halves p = halves_of(a), q = halves_of(b);
  return {value, ((p.high * q.high - value) + p.high * q.low + p.low * q.high) + p.low * q.low};
}

// 0 where nothing of a product underflows; else 1. No branch, for a loop that is to become vector code.
inline double is_underflown(double a, double b, double product) {
  constexpr double least = 0x1p-900;
  const double is_small = std::abs(product) > least ? 0.0 : 1.0;
  const double has_a = a == 0.0 ? 0.0 : 1.0;
  const double has_b = b == 0.0 ? 0.0 : 1.0;
  return is_small * has_a * has_b;
}

// The quick way of facet_cross(), term for term: component k of the cross product.
LRCS_WIDE void take_component(const double* ai, const double* bi, const double* ci, const double* aj, const double* bj,
                              const double* cj, double* __restrict cross, double* __restrict unsure) {
  for (std::size_t k = 0; k < block; ++k) {
    const Unrounded p = sum_of(bi[k], -ai[k]), q = sum_of(cj[k], -aj[k]);
    const Unrounded r = sum_of(bj[k], -aj[k]), s = sum_of(ci[k], -ai[k]);
    const Unrounded pq = split_product(p.value, q.value);
    const Unrounded rs = split_product(r.value, s.value);
    const ProductDifference quick = product_difference(p, q, r, s, pq, rs);
    const double is_cancelled = std::abs(quick.value) >= quick.least ? 0.0 : 1.0;
    cross[k] = quick.value;
    unsure[k] = is_cancelled + is_underflown(p.value, q.value, pq.value) + is_underflown(r.value, s.value, rs.value);
  }
}

void take_block(const std::vector<Vec3>& positions, std::span<const std::array<std::uint32_t, 3>> facets, Block& of) {
  for (std::size_t k = 0; k < facets.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t axis = 0; axis < 3; ++axis)
        of.corner[c][axis][k] = positions[facets[k][c]][static_cast<Eigen::Index>(axis)];
}

}  // namespace

void facet_crosses(const std::vector<Vec3>& positions, std::span<const std::array<std::uint32_t, 3>> facets,
                   std::span<Vec3> crosses) {
  Block of{};
  const auto& [a, b, c] = of.corner;
  for (std::size_t first = 0; first < facets.size(); first += block) {
    const auto here = facets.subspan(first, std::min(block, facets.size() - first));
    take_block(positions, here, of);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
      take_component(a[i].data(), b[i].data(), c[i].data(), a[j].data(), b[j].data(), c[j].data(),
                     of.cross[axis].data(), of.unsure[axis].data());
    }
    for (std::size_t k = 0; k < here.size(); ++k) {
      if (of.unsure[0][k] + of.unsure[1][k] + of.unsure[2][k] == 0.0)
        crosses[first + k] = {of.cross[0][k], of.cross[1][k], of.cross[2][k]};
      else
        crosses[first + k] = facet_cross(positions[here[k][0]], positions[here[k][1]], positions[here[k][2]]);
    }
  }
}

}  // namespace lrcs
