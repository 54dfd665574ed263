#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "lrcs/row_grid.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// What is drawn at a place of the picture: a facet; and whether another is in the same place, as far as doubles tell.
struct Drawn {
  static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max() >> 1U;
  std::uint32_t facet : 31 = nothing;
  std::uint32_t tied : 1 = 0;
};

// Facets drawn into the rows of a grid, each where it covers places, the nearest kept (a z-buffer): what rays through
// the same places would meet, for a fraction of the time where facets are not many more than places.
// domain: fewer than 2^31 - 1 facets.
// law: of facets that share an edge exactly one covers a place on it, as edges are computed the same for both.
// error: rounding of doubles; places closer than 2^-40 of the target count as one.
// A target where all edges are shared by facets of opposite senses may still show backs (it may be inside out, or pass
// through itself): all facets are drawn.
class RowDrawing {
 public:
  // Keeps a reference.
  explicit RowDrawing(const FacetMesh& mesh);

  void look_along(const RowGrid& grid);

  // Draws the next rows, as many as fit the cache. False where none are left.
  bool draw_more();

  // Of the rows drawn last.
  [[nodiscard]] std::uint32_t first_row() const { return first_; }
  [[nodiscard]] std::uint32_t last_row() const { return last_; }  // behind the last
  // shape: one a column of the grid.
  [[nodiscard]] std::span<const Drawn> row(std::uint32_t row) const {
    return {drawn_.data() + std::size_t{row - first_} * grid_.columns, grid_.columns};
  }

 private:
  struct Edge;
  struct Plane {
    double height = 0.0, per_x = 0.0, per_y = 0.0;  // at x = y = 0; a step
  };

  void place();
  void sort_into_bands();
  void find_lowest();
  [[nodiscard]] bool is_hidden(std::uint32_t facet) const;
  void draw(std::uint32_t facet);
  void draw_between(std::uint32_t facet, std::uint32_t low, std::uint32_t high, const Edge& one, const Edge& other,
                    const Plane& plane);
  [[nodiscard]] static bool find_plane(const Vec3& a, const Vec3& b, const Vec3& c, Plane& plane);

  const FacetMesh& mesh_;
  Placement placement_;
  RowGrid grid_;
  std::vector<Vec3> placed_;          // positions: x and y in steps, z toward the viewer
  std::vector<std::uint32_t> above_;  // of each position: the first row at or above it
  std::vector<double> offsets_;       // of rows
  std::uint32_t rows_a_band_ = 0, first_ = 0, last_ = 0;
  std::vector<std::vector<std::uint32_t>> fronts_, backs_;  // facets of each band
  std::vector<double> heights_;                             // of the band's places
  std::vector<Drawn> drawn_;                                // at them
  std::vector<double> lowest_;                              // height of a tile of them, fronts only
  std::uint32_t tiles_ = 0;                                 // side by side
};

}  // namespace lrcs
