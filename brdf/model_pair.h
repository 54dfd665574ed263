#pragma once
#include "brdf/scalar.h"

namespace lrcs {

// A model for one pair of directions, as a function of the normal, where nothing is saved by knowing the pair.
// value: f_r cos_i cos_r [1/sr].
template <class Model, class S>
struct ModelPair {
  Model model;
  Direction<S> wi, wr;

  [[nodiscard]] auto operator()(const Direction<S>& n) const { return model.f_cos_cos(wi, wr, n); }
  [[nodiscard]] double lobe_error(const Direction<S>& n) const requires requires { model.lobe_error(wi, wr, n); }
  { return model.lobe_error(wi, wr, n); }
};

}  // namespace lrcs
