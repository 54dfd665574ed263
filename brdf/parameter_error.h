#pragma once
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lrcs {

// A model's parameter is outside its domain. what(): "expected kb >= 0, found -1".
class ParameterError : public std::domain_error {
 public:
  ParameterError(std::string_view parameter, std::string_view expected, double found)
      : std::domain_error(fmt::format("expected {}, found {}", expected, found)), parameter_(parameter) {}
  // The parameter's name as in a scene file: kb, reflectance, ...
  [[nodiscard]] const std::string& parameter() const { return parameter_; }

 private:
  std::string parameter_;
};

// Throws ParameterError unless the value is finite and `inside`.
inline void require_parameter(std::string_view parameter, double value, bool inside, std::string_view expected) {
  if (!inside || !std::isfinite(value)) throw ParameterError(parameter, expected, value);
}

// Where a domain has no other end: products of such parameters stay finite.
inline constexpr double largest_parameter = 1e100;

// Throws ParameterError unless least <= value <= most.
inline void require_parameter_in(std::string_view parameter, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw ParameterError(parameter,
                       most < largest_parameter ? fmt::format("{} in [{}, {}]", parameter, least, most)
                                                : fmt::format("{} >= {}", parameter, least),
                       value);
}

}  // namespace lrcs
