#include "mesh/curved_patch.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

namespace lrcs {
namespace {

using Barycentric = std::array<double, 3>;

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

using Matrix = Eigen::Matrix<double, PatchRule::size, PatchRule::size>;

std::array<double, PatchRule::size> basis_at(const Barycentric& at) {
  const auto [a, b, c] = at;
  return {a * a, b * b, c * c, a * b, b * c, c * a, a * b * c};
}

// Of the basis in the polynomial that is 1 at a place of the rule and 0 at the others: a column each.
const Matrix& coefficients() {
  static const Matrix inverse = [] {
    Matrix values;
    for (std::size_t k = 0; k < PatchRule::size; ++k)
      values.row(static_cast<Eigen::Index>(k)) =
          Eigen::Map<const Eigen::RowVectorXd>(basis_at(patch_rule().at[k]).data(), PatchRule::size);
    return Matrix(values.inverse());
  }();
  return inverse;
}

}  // namespace

const PatchRule& patch_rule() {
  static const PatchRule rule = radon();
  return rule;
}

void turn_over(CurvedPatch& patch) {
  std::swap(patch.sagitta[0], patch.sagitta[2]);
  for (Vec3& normal : patch.normal) normal = -normal;
  for (const std::size_t orbit : {1, 4}) {
    std::swap(patch.normal[orbit + 1], patch.normal[orbit + 2]);
    std::swap(patch.area[orbit + 1], patch.area[orbit + 2]);
  }
}

PatchPolynomial::PatchPolynomial(const CurvedPatch& patch) {
  const Matrix& of_place = coefficients();
  coefficients_.fill(Vec3::Zero());
  for (std::size_t place = 0; place < PatchRule::size; ++place) {
    const Vec3 vector = patch.area[place] * patch.normal[place];
    for (std::size_t k = 0; k < PatchRule::size; ++k)
      coefficients_[k] += of_place(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(place)) * vector;
  }
}

Vec3 PatchPolynomial::at(const Barycentric& place) const {
  const auto basis = basis_at(place);
  Vec3 sum = basis[0] * coefficients_[0];
  for (std::size_t k = 1; k < PatchRule::size; ++k) sum += basis[k] * coefficients_[k];
  return sum;
}

CurvedPatch PatchPolynomial::part(const std::array<Barycentric, 3>& corners) const {
  const auto& [p, q, r] = corners;
  // Twice the area between the places in two of their coordinates.
  return part(corners, (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]));
}

CurvedPatch PatchPolynomial::part(const std::array<Barycentric, 3>& corners, double share) const {
  CurvedPatch part;
  const auto& [p, q, r] = corners;
  const PatchRule& rule = patch_rule();
  for (std::size_t k = 0; k < PatchRule::size; ++k) {
    Barycentric place{};
    for (std::size_t c = 0; c < 3; ++c) place[c] = rule.at[k][0] * p[c] + rule.at[k][1] * q[c] + rule.at[k][2] * r[c];
    const Vec3 vector = at(place);
    const double length = vector.norm();
    part.area[k] = share * length;
    part.normal[k] = length > 0.0 ? Vec3(vector / length) : vector;
  }
  return part;
}

}  // namespace lrcs
