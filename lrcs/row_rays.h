#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "lrcs/row_grid.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

class EmbreeScene;

// What stands at a place of the picture: a facet, lit or not; or nothing.
struct Seen {
  static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t facet = nothing;
  bool lit = false;
  [[nodiscard]] bool any() const { return facet != nothing; }
};

// A place of a row grid, in its steps.
struct GridPlace {
  double x = 0.0, y = 0.0;
};

// Rays from the receiver through places of a row grid, in packets; from what they meet, where the transmitter stands
// elsewhere, rays on to it. A facet is lit only if both look at the same side of it.
// error: Embree's: floats around 1. Where two facets are nearer to each other than 1e-6 of the target either is met.
class RowRays {
 public:
  static constexpr std::size_t width = 16;

  // Keeps references.
  RowRays(const FacetMesh& mesh, const EmbreeScene& scene);
  ~RowRays();

  void look_along(const RowGrid& grid, const Vec3& to_transmitter);

  // What stands at the first `count` places. They should be neighbours: far apart
  // rays take ten times as long.
  void cast(const std::array<GridPlace, width>& places, std::size_t count, std::array<Seen, width>& seen);

 private:
  struct Packet;
  void light(std::size_t count, std::array<Seen, width>& seen);

  const FacetMesh& mesh_;
  const EmbreeScene& scene_;
  std::unique_ptr<Packet> packet_;
  Vec3 from_, along_x_, along_y_;  // placed: of x = y = 0, before the target; a step each
  Vec3 to_transmitter_, to_receiver_;
  bool bistatic_ = false;
};

}  // namespace lrcs
