#include "mesh/curved_patch.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

namespace lrcs {
namespace {

using Place = std::array<double, 3>;
using Basis = Eigen::Matrix<double, PatchRule::size, 1>;

PatchRule radon() {
  const double root = std::sqrt(15.0);
  // Two orbits of three places: (1 - 2 a, a, a) and its turns.
  const double near = (6.0 - root) / 21.0, far = (6.0 + root) / 21.0;
  const double near_weight = (155.0 - root) / 1200.0, far_weight = (155.0 + root) / 1200.0;
  // Degree 2 without the centroid: the weights' sum is 1, and that of the squares' of each coordinate 1/2.
  const auto square = [](double a) { return (1.0 - 2.0 * a) * (1.0 - 2.0 * a) + 2.0 * a * a; };
  const double near_lower = (0.5 - square(far)) / (3.0 * (square(near) - square(far)));
  PatchRule rule{};
  rule.at[0] = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
  rule.weight[0] = 9.0 / 40.0;
  for (std::size_t k = 0; k < 3; ++k) {
    rule.at[1 + k] = {near, near, near};
    rule.at[1 + k][k] = 1.0 - 2.0 * near;
    rule.at[4 + k] = {far, far, far};
    rule.at[4 + k][k] = 1.0 - 2.0 * far;
    rule.weight[1 + k] = near_weight;
    rule.weight[4 + k] = far_weight;
    rule.lower[1 + k] = near_lower;
    rule.lower[4 + k] = 1.0 / 3.0 - near_lower;
  }
  return rule;
}

Basis basis_at(const Place& at) {
  const auto [a, b, c] = at;
  Basis basis;
  basis << a * a, b * b, c * c, a * b, b * c, c * a, a * b * c;
  return basis;
}

// The weight of each place of the rule in the value at another.
Basis weights_at(const Place& at) {
  static const Eigen::Matrix<double, PatchRule::size, PatchRule::size> inverse = [] {
    Eigen::Matrix<double, PatchRule::size, PatchRule::size> values;
    for (std::size_t k = 0; k < PatchRule::size; ++k)
      values.col(static_cast<Eigen::Index>(k)) = basis_at(patch_rule().at[k]);
    return values.inverse().eval();
  }();
  return inverse * basis_at(at);
}

}  // namespace

const PatchRule& patch_rule() {
  static const PatchRule rule = radon();
  return rule;
}

void turn_over(CurvedPatch& patch) {
  for (Vec3& normal : patch.normal) normal = -normal;
  for (const std::size_t orbit : {1, 4}) {
    std::swap(patch.normal[orbit + 1], patch.normal[orbit + 2]);
    std::swap(patch.area[orbit + 1], patch.area[orbit + 2]);
  }
}

Vec3 area_vector_at(const CurvedPatch& patch, const Place& place) {
  const Basis weights = weights_at(place);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < PatchRule::size; ++k)
    sum += weights[static_cast<Eigen::Index>(k)] * patch.area[k] * patch.normal[k];
  return sum;
}

CurvedPatch part_of(const CurvedPatch& patch, const std::array<Place, 3>& corners) {
  CurvedPatch part;
  const auto& [p, q, r] = corners;
  // Of the facet's area: twice the area between the places in two of their coordinates.
  const double share = (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]);
  for (std::size_t k = 0; k < PatchRule::size; ++k) {
    Place at{};
    for (std::size_t c = 0; c < 3; ++c)
      at[c] = patch_rule().at[k][0] * p[c] + patch_rule().at[k][1] * q[c] + patch_rule().at[k][2] * r[c];
    const Vec3 vector = area_vector_at(patch, at);
    const double length = vector.norm();
    part.area[k] = share * length;
    part.normal[k] = length > 0.0 ? Vec3(vector / length) : patch.normal[0];
  }
  return part;
}

}  // namespace lrcs
