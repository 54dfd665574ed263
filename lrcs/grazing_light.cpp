#include "lrcs/grazing_light.h"

#include <algorithm>

#include "lrcs/placement.h"
#include "lrcs/return_error.h"

namespace lrcs {

double GrazingLight::part_at(std::uint32_t facet, double cos_i) const {
  const Vec3& n = mesh_.normals[facet];
  if (is_exactly_edge_on(n, to_transmitter_)) return 0.0;
  if (std::abs(cos_i) > doubtful_cosine && cos_i * n.dot(to_receiver_) < 0.0) return 0.0;
  const auto [a, b, c] = mesh_.corners(facet);
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  const double width = scale_ * (b - a).cross(c - a).norm() / longest;
  constexpr double off = 2.0 * float_error;
  return off < std::abs(cos_i) * width ? off / (std::abs(cos_i) * width) : 1.0;
}

}  // namespace lrcs
