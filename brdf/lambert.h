#pragma once
#include <numbers>

#include "brdf/model_pair.h"
#include "brdf/parameter_error.h"
#include "brdf/scalar.h"

namespace lrcs {

// An ideally diffuse surface.
// value: f_r = reflectance / pi  [1/sr]
// domain: reflectance in [0, 1]; else ParameterError. T: its scalar.
// laws: reciprocal; the albedo is the reflectance, whatever the direction (tests/brdf/albedo_test.cpp).
// The functions are those of every model: brdf/brdf.h.
template <class T>
class LambertModel {
 public:
  static constexpr bool is_reciprocal = true;

  LambertModel() = default;  // black
  explicit LambertModel(const T& reflectance) : reflectance_(reflectance) {
    const double rho = plain_value(reflectance);
    require_parameter("reflectance", rho, rho >= 0.0 && rho <= 1.0, "reflectance in [0, 1]");
  }

  [[nodiscard]] const T& reflectance() const { return reflectance_; }
  [[nodiscard]] bool conserves_energy() const { return true; }
  [[nodiscard]] double largest() const { return plain_value(reflectance_) / std::numbers::pi; }

  template <class S>
  [[nodiscard]] ResultScalar<T, S> f_cos_cos(const Direction<S>& wi, const Direction<S>& wr,
                                             const Direction<S>& n) const {
    return product(S(wi.dot(n)), S(wr.dot(n)));
  }

  template <class S>
  [[nodiscard]] ResultScalar<T, S> f_cos_cos_retro(const S& cos_theta) const {
    return product(cos_theta, cos_theta);
  }

  [[nodiscard]] double pair_error(const Direction<double>& /*wi*/, const Direction<double>& /*wr*/) const {
    return 0.0;
  }

  template <class S>
  [[nodiscard]] ModelPair<LambertModel, S> for_pair(const Direction<S>& wi, const Direction<S>& wr) const {
    return {*this, wi, wr};
  }

 private:
  template <class S>
  [[nodiscard]] ResultScalar<T, S> product(const S& cos_i, const S& cos_r) const {
    using R = ResultScalar<T, S>;
    if (!is_above(cos_i) || !is_above(cos_r)) return R(0.0);
    return R(reflectance_ * cos_i * cos_r) / R(std::numbers::pi_v<long double>);
  }
  T reflectance_ = T(0.0);
};

using Lambert = LambertModel<double>;

}  // namespace lrcs
