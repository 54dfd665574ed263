#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// The facets of a target as visibility uses them: all that can block, in an order in which neighbours lie together.
// laws: vertices of equal position are one; every vertex is used; facets of area zero are left out; a facet's first
// corner is opposite to its longest side (the best conditioned coordinates a thin facet can have), its winding is kept.
// Positions are the mesh's times a power of two that brings the target's size near 1, so they are exact, and products
// of three lengths neither overflow nor vanish. `centre` is no corner of anything: a place in the middle of the target.
struct Occluders {
  // Cosine of what two facets' normals at a corner differ by at most where the surface goes on smoothly: a degree.
  static constexpr double smooth = 0.9998;

  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> facets;
  std::vector<Vec3> cross;              // facet_cross() of the corners: twice the area, along the front's normal
  std::vector<std::uint32_t> original;  // number of the facet in the mesh
  // Of the true surface at the facet's corners, unit; empty where the mesh has no curved facets.
  std::vector<std::array<Vec3, 3>> corner_normals;
  std::vector<std::array<Vec3, 3>> sagittas;  // of the sides from corner k to corner k + 1; empty with the normals
  std::vector<std::uint8_t> first_corner;     // the mesh facet's corner that comes first here; empty with the normals
  Vec3 centre = Vec3::Zero();

  explicit Occluders(const FacetMesh& mesh);
  // Those of the facets that are kept (not 0), in the same order. shape: kept: one a facet.
  Occluders(const Occluders& all, const std::vector<std::uint8_t>& kept);
  [[nodiscard]] std::size_t size() const { return facets.size(); }

 private:
  void take_facets(const FacetMesh& mesh);
  void keep_areas();
  void order_facets();
  void order_vertices();
};

}  // namespace lrcs
