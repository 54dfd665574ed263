#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/facet_tree.h"
#include "lrcs/outline_bend.h"
#include "lrcs/surface.h"

namespace lrcs {

// An edge across which the number of facets changes, as seen along one direction: a fold (silhouette), a boundary, or
// one of many facets.
struct OutlineEdge {
  std::uint32_t low, high;  // vertices
  int gain;                 // facets on the right less those on the left, looking from low to high
  Vec3 at_low, at_high;     // in the view
  OutlineBend bend;         // of curved surfaces
};

// A target as seen along one direction: places across the view, which way facets face, and the edges of the outline.
// One object a thread; its memory is used again from direction to direction.
class ViewOutline {
 public:
  explicit ViewOutline(const Surface& surface) : surface_(&surface) {}

  // Unit vector toward the viewer.
  void look_along(const Vec3& toward);

  [[nodiscard]] const ViewFrame& frame() const { return frame_; }
  // Coordinates of the vertices along the view (ViewFrame). error: rounding().
  [[nodiscard]] const double* x() const { return x_.data(); }
  [[nodiscard]] const double* y() const { return y_.data(); }
  [[nodiscard]] const double* z() const { return z_.data(); }
  [[nodiscard]] double rounding() const { return rounding_; }

  // +1: a facet's front is seen, -1: its back, 0: edge-on as far as rounding can tell. shape: one a facet.
  [[nodiscard]] const std::int8_t* facing() const { return facing_.data(); }
  // Is any of the latter perhaps not exactly edge-on? It is left out, and may hide a strip as wide as rounding.
  [[nodiscard]] bool is_doubtful() const { return doubtful_; }
  // The facing of the facets that count as layers, 0 for others: edge-on ones, and backs of solids. One entry more, 0.
  [[nodiscard]] const std::int8_t* counted() const { return counted_.data(); }
  [[nodiscard]] int counts(std::uint32_t facet) const { return int{counted_[facet]}; }
  [[nodiscard]] const std::vector<OutlineEdge>& edges() const { return edges_; }

 private:
  void face_facets();
  void find_edges();
  void add_edge(std::uint32_t edge, int gain);

  const Surface* surface_;
  ViewFrame frame_{Vec3::UnitZ(), Vec3::Zero()};
  double rounding_ = 0.0;
  bool doubtful_ = false;
  std::vector<double> x_, y_, z_;
  std::vector<std::int8_t> facing_, counted_;
  std::vector<OutlineEdge> edges_;
};

}  // namespace lrcs
