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

// Rays from the receiver through places of a row grid, in packets; from what they meet, where the transmitter stands
// elsewhere, rays on to it. A facet is lit only if both look at the same side of it.
// error: Embree's: floats around 1. Where two facets are nearer to each other than 1e-6 of the target either is met.
class RowRays {
 public:
  static constexpr std::uint32_t tile = 4;  // rows and places of a row that are cast together
  static constexpr std::size_t width = std::size_t{tile} * tile;

  // Keeps references.
  RowRays(const FacetMesh& mesh, const EmbreeScene& scene);
  ~RowRays();

  void look_along(const RowGrid& grid, const Vec3& to_transmitter);

  // What stands at the places of `tile` rows and columns, row by row; nothing where the grid ends.
  // domain: `row` a multiple of `tile`.
  void cast(std::uint32_t row, std::uint32_t column, std::array<Seen, width>& seen);
  // Where ray k of the last cast has met something. frame: that of Placement.
  [[nodiscard]] Vec3 place(std::size_t k) const;

 private:
  struct Packet;
  void start(std::uint32_t row, std::uint32_t column);
  void start_row_of_tiles(std::uint32_t row);
  void light(std::array<Seen, width>& seen);

  const FacetMesh& mesh_;
  const EmbreeScene& scene_;
  std::unique_ptr<Packet> packet_;
  RowGrid grid_;
  Vec3 to_transmitter_, to_receiver_;
  bool bistatic_ = false;
};

}  // namespace lrcs
