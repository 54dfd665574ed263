#pragma once
#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "base/vec3.h"
#include "brdf/material.h"

namespace lrcs {

// What rounding makes of a facet's return: the parts of bound_m2 (docs/methods.md, section 6).

// Cosines of size up to this may have either sign, by rounding of normal and direction.
inline constexpr double doubtful_cosine = 16.0 * 0x1p-53;

// No rounding: every term of the cosine is zero, as that of the exact normal is.
[[nodiscard]] inline bool is_exactly_edge_on(const Vec3& n, const Vec3& w) {
  return n.cwiseProduct(w).isZero(0.0);
}

// Rounding of a model's value, relative: the angle's rounding counts 1/cos near grazing, the rest is a few dozen
// operations and an exponent of up to a hundred. Held by CrossSection.BoundHoldsAgainstExtendedPrecision.
inline constexpr double model_error = 512.0 * 0x1p-53;

// The relative error of what a facet returns whose lesser cosine is this, above zero: near grazing all of it.
[[nodiscard]] inline double grazing_error(double cosine) {
  return model_error / std::max(cosine, model_error);
}

// For a facet that someone sees edge-on, as far as rounding can tell: the most that the side may return which n is the
// normal of [1/sr]. pair: a model's for_pair(wi, wr).
template <class Pair>
[[nodiscard]] double largest_edge_on(const Pair& pair, Vec3 n, const Vec3& wi, const Vec3& wr) {
  for (const Vec3& w : {wi, wr})
    if (std::abs(n.dot(w)) <= doubtful_cosine) n += 2.0 * doubtful_cosine * w;
  return std::max(0.0, pair(n));
}

// Has a model, by its pair, a lobe that rounding moves?
template <class Pair>
concept HasLobeError = requires(const Pair& pair, const Vec3& n) {
  pair.lobe_error(n);
};

// How far rounding may move the lobe of a model, for one pair of directions and one normal [1/sr]; 0 of models without.
template <class Pair>
[[nodiscard]] double lobe_error(const Pair& pair, const Vec3& n) {
  if constexpr (HasLobeError<Pair>)
    return pair.lobe_error(n);
  else
    return 0.0;
}

// The largest BrdfModel::pair_error() among the materials [1].
[[nodiscard]] inline double pair_error(const std::vector<Material>& materials, const Vec3& wi, const Vec3& wr) {
  double most = 0.0;
  for (const Material& m : materials)
    most = std::max(most, std::visit([&](const auto& model) { return model.pair_error(wi, wr); }, m.brdf));
  return most;
}

// Does the material return nothing, from whatever direction? It blocks all the same.
[[nodiscard]] inline bool returns_nothing(const Material& material) {
  return std::visit([](const auto& model) { return model.largest() == 0.0; }, material.brdf);
}

}  // namespace lrcs
