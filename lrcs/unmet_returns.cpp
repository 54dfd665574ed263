#include "lrcs/unmet_returns.h"

#include <algorithm>
#include <cmath>

#include "lrcs/return_error.h"

namespace lrcs {
namespace {

constexpr std::size_t bins = 512;  // of sqrt(1 - cos): as fine in angle at the peak as elsewhere
constexpr double places = 4.0;

}  // namespace

UnmetReturns::UnmetReturns(const Target& target) : target_(target), returns_(target) {
  const Vec3 d = Vec3::UnitZ();
  returns_.look_along(d, d);
  std::vector<double> brightest;
  for (std::uint32_t m = 0; m < target.materials.size(); ++m) {
    add_retro(m);
    brightest.push_back(*std::max_element(retro_.end() - bins, retro_.end()));
  }
  for (const auto* materials : {&target.material, &target.back})
    for (const std::uint32_t m : *materials) brightest_retro_ = std::max(brightest_retro_, brightest[m]);
}

// The larger at a bin's ends.
void UnmetReturns::add_retro(std::uint32_t material) {
  const auto at = [&](std::size_t k) {
    const double s = static_cast<double>(k) / bins, cosine = 1.0 - s * s;
    return returns_.of_material(material, {std::sqrt(1.0 - cosine * cosine), 0.0, cosine});
  };
  for (std::size_t k = 0; k < bins; ++k) retro_.push_back(std::max(at(k), at(k + 1)));
}

double UnmetReturns::beyond(double largest, const Vec3& to_transmitter, const Vec3& to_receiver, double side) {
  const double of_area = 1.0 / (side * side);
  if (to_transmitter != to_receiver) {
    const Excess found = excess(largest, to_transmitter, to_receiver);
    return std::min(places * found.most, of_area * found.sum);
  }
  // Not worth a pass over the facets.
  constexpr double little = 0.1;
  const double most = places * std::max(0.0, brightest_retro_ - largest);
  if (most <= little * largest) return most;
  const Excess found = retro_excess(largest, to_receiver, most / of_area);
  return std::min(places * found.most, of_area * found.sum);
}

// enough: a sum at which to stop.
UnmetReturns::Excess UnmetReturns::retro_excess(double largest, const Vec3& d, double enough) const {
  const FacetMesh& mesh = target_.mesh;
  Excess found;
  for (std::size_t f = 0; f < mesh.size() && found.sum < enough; ++f) {
    double cosine = mesh.normals[f].dot(d);
    if (cosine < 0.0 && target_.sides == Sides::front) continue;
    const std::size_t material = (cosine < 0.0 ? target_.back_material() : target_.material)[f];
    cosine = std::min(std::abs(cosine), 1.0);
    const auto bin = static_cast<std::size_t>(bins * std::sqrt(1.0 - cosine));
    const double more = retro_[material * bins + std::min(bin, bins - 1)] - largest;
    if (more <= 0.0) continue;
    found.most = std::max(found.most, more);
    found.sum += more * cosine * mesh.areas[f];
  }
  return found;
}

UnmetReturns::Excess UnmetReturns::excess(double largest, const Vec3& to_transmitter, const Vec3& to_receiver) {
  const FacetMesh& mesh = target_.mesh;
  returns_.look_along(to_transmitter, to_receiver);
  Excess found;
  for (std::uint32_t f = 0; f < mesh.size(); ++f) {
    const double cos_i = mesh.normals[f].dot(to_transmitter), cos_r = mesh.normals[f].dot(to_receiver);
    if (cos_i * cos_r < 0.0 && std::abs(cos_i) > doubtful_cosine) continue;
    const double more = returns_.most(f) - largest;
    if (more <= 0.0) continue;
    found.most = std::max(found.most, more);
    found.sum += more * std::abs(cos_r) * mesh.areas[f];
  }
  return found;
}

}  // namespace lrcs
