#pragma once
#include <concepts>
#include <variant>

#include "base/vec3.h"
#include "brdf/cook_torrance.h"
#include "brdf/lambert.h"
#include "brdf/phong.h"
#include "brdf/steinvall.h"
#include "brdf/tabulated.h"
#include "brdf/wu.h"

namespace lrcs {

// What every model offers. wi, wr: unit, from the surface to the transmitter and to the receiver; n: unit normal.
//   f_cos_cos(wi, wr, n)      value: f_r cos_i cos_r [1/sr], in [0, largest()] everywhere; 0 where either cosine is not
//                             positive. On a scalar template: double, long double, dual numbers.
//                             Tabulated may throw NotMeasured instead.
//   f_cos_cos_retro(cosine)   the same at wi = wr: the monostatic case.
//   for_pair(wi, wr)          the same as a function of the normal, for many normals: k(n) == f_cos_cos(wi, wr, n).
//   pair_error(wi, wr)        relative error [1] of what depends on the pair alone, for wi and wr rounded to doubles.
//   largest()                 [1/sr] a bound of f_cos_cos, finite.
//   is_reciprocal             f_r(wi, wr) == f_r(wr, wi).
//   conserves_energy()        the albedo is promised to be at most 1.
//   lobe_error(wi, wr, n)     of models with a narrow lobe only: how far rounding of wi, wr, n may move it [1/sr].
template <class M>
concept BrdfModel = requires(const M model, const Vec3 w, double cosine) {
  { model.f_cos_cos(w, w, w) } -> std::same_as<double>;
  { model.f_cos_cos_retro(cosine) } -> std::same_as<double>;
  { model.for_pair(w, w)(w) } -> std::same_as<double>;
  { model.pair_error(w, w) } -> std::same_as<double>;
  { model.largest() } -> std::same_as<double>;
  { model.conserves_energy() } -> std::same_as<bool>;
  { M::is_reciprocal } -> std::convertible_to<bool>;
};

// The closed list of models. Visit it once per batch of facets.
// A new model: its header, its place here, its forms in brdf/form_list.h; readers, writers, fits and law tests follow.
// Tabulated alone has no parameters, and so no form.
using Brdf = std::variant<Lambert, Wu, Steinvall, Phong, CookTorranceBeckmann, CookTorranceGgx, Tabulated>;

template <class... Models>
constexpr bool all_are_models(const std::variant<Models...>* /*list*/) {
  return (BrdfModel<Models> && ...);
}
static_assert(all_are_models(static_cast<const Brdf*>(nullptr)));

// A model for directions from which perhaps no one looks: the model itself, but one that never throws NotMeasured.
template <class M>
[[nodiscard]] const M& supposed(const M& model) {
  return model;
}
[[nodiscard]] inline Tabulated supposed(const Tabulated& model) {
  return model.outside() == Outside::error ? model.with(Outside::nearest) : model;
}

// The true BRDF [1/sr]; 0 where either direction is not above the surface. May exceed largest(): it is divided by the
// cosines of both directions.
[[nodiscard]] double f_r(const Brdf& brdf, const Vec3& wi, const Vec3& wr, const Vec3& n);

// The same from angles [rad]: theta_i and theta_r from the normal, phi between the azimuths.
// phi = 0 is retro-reflection, pi the specular side, whatever convention the material's numbers were made in.
[[nodiscard]] double f_r_angles(const Brdf& brdf, double theta_i, double theta_r, double phi);

}  // namespace lrcs
