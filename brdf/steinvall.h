#pragma once
#include <cmath>

#include "brdf/beckmann.h"
#include "brdf/half_vector_model.h"
#include "brdf/parameter_error.h"

namespace lrcs {

// Steinvall's four parameters: a specular lobe and a diffuse term of any breadth, for monostatic laser radar.
// value: at wi = wr: f_r = A exp(-tan^2 theta / s^2) / cos^6 theta + B cos^m theta  [1/sr]
// bistatic: the source has no such form. Here theta gives way to alpha, the angle between normal and half vector, in
//   the lobe, cos^2 theta to cos_i cos_r:
//   f_r cos_i cos_r = A exp(-tan^2 alpha / s^2) / cos^4 alpha + B (cos_i cos_r)^(1 + m/2).
// domain: A, B, m >= 0; s in [1e-6, 100], a narrower lobe is a mirror; largest() finite. Else ParameterError.
// laws: reciprocal. The albedo is not bounded: A and B are free.
// check: tests/brdf/high_precision_test.cpp, 1e-12; closed forms of plate and sphere in tests/lrcs/steinvall_test.cpp.
// source: O. Steinvall, Applied Optics 39(24), 4381, 2000.
template <class T>
class SteinvallModel : public HalfVectorModel<T, SteinvallModel<T>> {
 public:
  SteinvallModel(const T& A, const T& B, const T& s, const T& m) : A_(A), B_(B), s_(s), m_(m) {
    const auto require = [](std::string_view name, const T& x, double least, double most) {
      require_parameter_in(name, plain_value(x), least, most);
    };
    require("A", A, 0.0, largest_parameter);
    require("B", B, 0.0, largest_parameter);
    require("s", s, 1e-6, Beckmann::largest_s);
    require("m", m, 0.0, largest_parameter);
  }

  [[nodiscard]] const T& A() const { return A_; }
  [[nodiscard]] const T& B() const { return B_; }
  [[nodiscard]] const T& s() const { return s_; }
  [[nodiscard]] const T& m() const { return m_; }
  [[nodiscard]] double largest() const {
    return plain_value(A_) * Beckmann::highest(plain_value(s_)) + plain_value(B_);
  }
  [[nodiscard]] bool conserves_energy() const { return false; }

  [[nodiscard]] double lobe_error(const Direction<double>& wi, const Direction<double>& wr,
                                  const Direction<double>& n) const {
    const double s = plain_value(s_);
    const auto h = half_vector(wi, wr, n);
    return plain_value(A_) * Beckmann::lobe(s, h.cos2, h.sin2) * lobe_rounding<Beckmann>(s, h);
  }

 private:
  friend HalfVectorModel<T, SteinvallModel>;

  template <class S>
  [[nodiscard]] ResultScalar<T, S> value(const HalfVector<S>& h) const {
    using R = ResultScalar<T, S>;
    using std::pow;
    const R diffuse = R(B_) * pow(R(h.product()), R(R(1.0) + R(0.5) * R(m_)));
    return R(R(A_) * Beckmann::lobe(R(s_), h.cos2, h.sin2) + diffuse);
  }

  T A_, B_, s_, m_;
};

using Steinvall = SteinvallModel<double>;

}  // namespace lrcs
