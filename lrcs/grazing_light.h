#pragma once
#include <cmath>
#include <cstdint>

#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// How much of a facet that the transmitter sees nearly edge-on rays in floats may wrongly find lit or dark: a shadow's
// end lies float_error / cos_i off, and what rises less than float_error above the facet casts none.
// value: min(1, 2 float_error / (cos_i width)), width the facet's height over its longest side (target's largest side:
//   1); 0 above cos_i = 0.01, where exactly edge-on, and where the other side is lit for certain.
class GrazingLight {
 public:
  // Keeps a reference.
  explicit GrazingLight(const FacetMesh& mesh, double scale) : mesh_(mesh), scale_(scale) {}

  void look_along(const Vec3& to_transmitter, const Vec3& to_receiver) {
    to_transmitter_ = to_transmitter;
    to_receiver_ = to_receiver;
  }

  [[nodiscard]] double doubtful_part(std::uint32_t facet) const {
    constexpr double grazing = 0.01;
    const double cos_i = mesh_.normals[facet].dot(to_transmitter_);
    return std::abs(cos_i) > grazing ? 0.0 : part_at(facet, cos_i);
  }

 private:
  [[nodiscard]] double part_at(std::uint32_t facet, double cos_i) const;

  const FacetMesh& mesh_;
  double scale_;
  Vec3 to_transmitter_, to_receiver_;
};

}  // namespace lrcs
