#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// The curved facets of a target, ready to be integrated for many directions.
class CurvedSurface {
 public:
  static constexpr std::uint32_t none = 0xffffffff;
  // The places of the rule reach 0.8 of the way from the middle to the corners, and normals turn evenly, or nearly so.
  static constexpr double beyond_places = 1.5;

  struct Facet {
    std::uint32_t facet;                    // of the mesh
    std::array<std::uint32_t, 3> adjacent;  // facets of the mesh that go on smoothly beyond its sides; or none
    Vec3 axis;                              // unit: the mean of its normals
    double spread;                          // sine of the angle within which all its normals lie round the axis
    bool folded;                            // its area is below zero somewhere
    bool planar;                            // its normals are all equal
    double area;                            // [m^2]
    CurvedPatch patch;                      // [m^2]
  };

  CurvedSurface() = default;
  // mesh: in the body frame; welded, or facets have no neighbours.
  explicit CurvedSurface(const FacetMesh& mesh);

  [[nodiscard]] bool empty() const { return facets_.empty(); }
  [[nodiscard]] const std::vector<Facet>& facets() const { return facets_; }
  // Index into facets() of a facet of the mesh, or none.
  [[nodiscard]] std::uint32_t place_of(std::size_t facet) const { return places_.empty() ? none : places_[facet]; }

 private:
  void find_adjacent(const FacetMesh& mesh);

  std::vector<std::uint32_t> places_;
  std::vector<Facet> facets_;
};

}  // namespace lrcs
