#pragma once
#include <Eigen/Core>
#include <limits>
#include <type_traits>

namespace lrcs {

// A direction on any scalar: double, long double, dual numbers.
template <class S>
using Direction = Eigen::Matrix<S, 3, 1>;

// The scalar of a model with parameters of type T at directions of type S: one of the two may be richer than double.
template <class T, class S>
using ResultScalar = std::conditional_t<std::is_same_v<T, double>, S, T>;

// The number without its derivatives. A dual number gives it as value(), or is Ceres' Jet.
template <class T>
[[nodiscard]] double plain_value(const T& x) {
  if constexpr (std::is_convertible_v<T, double>)
    return static_cast<double>(x);
  else if constexpr (requires { x.value(); })
    return static_cast<double>(x.value());
  else
    return static_cast<double>(x.a);
}

// A direction is above the surface where its cosine is a positive normal number: at smaller ones quotients overflow.
template <class S>
[[nodiscard]] bool is_above(const S& cosine) {
  return cosine >= S(std::numeric_limits<double>::min());
}

}  // namespace lrcs
