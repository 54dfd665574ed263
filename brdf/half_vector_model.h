#pragma once
#include "brdf/half_vector.h"
#include "brdf/model_pair.h"
#include "brdf/scalar.h"

namespace lrcs {

// What models share that depend on the directions through their half vector: of Model, which has
// value(HalfVector<S>) -> f_r cos_i cos_r above the surface [1/sr], the functions that brdf/brdf.h asks for.
// laws: reciprocal, where value() is, as it knows the half vector and the cosines' product only.
template <class T, class Model>
class HalfVectorModel {
 public:
  static constexpr bool is_reciprocal = true;

  template <class S>
  [[nodiscard]] ResultScalar<T, S> f_cos_cos(const Direction<S>& wi, const Direction<S>& wr,
                                             const Direction<S>& n) const {
    if (!is_above(S(wi.dot(n))) || !is_above(S(wr.dot(n)))) return ResultScalar<T, S>(0.0);
    return model().value(half_vector(wi, wr, n));
  }

  template <class S>
  [[nodiscard]] ResultScalar<T, S> f_cos_cos_retro(const S& cos_theta) const {
    return is_above(cos_theta) ? model().value(half_vector_retro(cos_theta)) : ResultScalar<T, S>(0.0);
  }

  template <class S>
  [[nodiscard]] ModelPair<Model, S> for_pair(const Direction<S>& wi, const Direction<S>& wr) const {
    return {model(), wi, wr};
  }

  [[nodiscard]] double pair_error(const Direction<double>& /*wi*/, const Direction<double>& /*wr*/) const {
    return 0.0;
  }

 private:
  [[nodiscard]] const Model& model() const { return static_cast<const Model&>(*this); }
};

}  // namespace lrcs
