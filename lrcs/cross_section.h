#pragma once
#include <cstdint>
#include <vector>

#include "base/estimate.h"
#include "base/vec3.h"
#include "brdf/material.h"
#include "lrcs/curved_surface.h"
#include "lrcs/visibility.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// Which side of a facet reflects: whichever is seen, or only the outward one. Both sides block.
enum class Sides { both, front };

// A target ready to be integrated.
// shape: material: one a facet, an index into materials; back: the same, or none. frame: body [m].
struct Target {
  FacetMesh mesh;
  std::vector<Material> materials;
  std::vector<std::uint32_t> material;
  Sides sides = Sides::both;
  CurvedSurface curved{};             // of the mesh; empty where mesh.curved is
  std::vector<std::uint32_t> back{};  // of sides seen from behind the winding; empty: both sides have `material`

  // shape: one a facet.
  [[nodiscard]] const std::vector<std::uint32_t>& back_material() const { return back.empty() ? material : back; }
  // Do all sides that reflect have the same?
  [[nodiscard]] bool has_one_material() const;
};

// Laser radar cross section of a target for one pair of directions.
struct CrossSection {
  Estimate sigma;                     // [m^2]
  double seen_area = 0.0;             // [m^2] lit AND seen, projected toward the receiver
  std::vector<double> facet_sigma;    // [m^2] each facet's share; sums to sigma.value
  std::vector<double> seen_fraction;  // 0..1, each facet
};

// value: sigma = 4 pi Sum over facets of f_r cos(theta_i) cos(theta_r) A (seen fraction)  [m^2]
// laws: see tests/lrcs/metamorphic_test.cpp (scaling, rotation, subdivision, reciprocity, ...).
// error: sigma.bound holds the rounding of the seen fractions, of the BRDF and of the sum.
// source: docs/methods.md, section 1.
[[nodiscard]] CrossSection cross_section(const Target& target, const Visibility& visibility, const Vec3& to_transmitter,
                                         const Vec3& to_receiver);

// The same from seen fractions that are known: one a facet, as Visibility::seen_fraction() gives them.
[[nodiscard]] CrossSection cross_section(const Target& target, const std::vector<Estimate>& seen,
                                         const Vec3& to_transmitter, const Vec3& to_receiver);
void cross_section(const Target& target, const std::vector<Estimate>& seen, const Vec3& to_transmitter,
                   const Vec3& to_receiver, CrossSection& result, SeenParts* parts = nullptr);

}  // namespace lrcs
