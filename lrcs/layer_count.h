#pragma once
#include <cstdint>
#include <vector>

namespace lrcs {

// A piece of an outline in a facet's own coordinates (u, v): the facet is the triangle u >= 0, v >= 0, u + v <= 1.
struct LayerEdge {
  double u0 = 0.0, v0 = 0.0, u1 = 0.0, v1 = 0.0;  // ends, in any order
  int step = 0;                                   // layers gained where the edge is crossed toward larger u
};

// Counts the layers that lie over a facet, from their outlines alone, and measures where there are none.
// The layers are the polygons whose outlines sum up to the edges; edges that two layers share with opposite steps may
// be left out. Horizontal slabs between the ends and the crossings of the edges hold trapezoids; the count is walked
// from left to right in each. error: positions closer than `tolerance` (the rounding error of the coordinates) are
// taken as one, so the area is off by at most 2 tolerance per edge. source: Appel, "The notion of quantitative
// invisibility", Proc. 22nd ACM National Conf., 387-393, 1967.
class LayerCount {
 public:
  // Area of the part of the unit triangle that no layer covers, 0..1/2.
  [[nodiscard]] double uncovered_area(const std::vector<LayerEdge>& edges, double tolerance);

 private:
  struct Line {  // an edge within one slab
    double bottom, top;
    int step;
    std::uint32_t rank;  // makes the order of coincident lines definite
  };
  using Lines = std::vector<Line>;

  void collect_slab(double low, double high);
  double slab_area(const Lines& all, double height);
  void snap(Lines& lines, double Line::*end) const;

  std::vector<LayerEdge> edges_;
  std::vector<std::uint32_t> active_;
  std::vector<double> heights_;
  Lines lines_;
  double tolerance_ = 0.0;
};

}  // namespace lrcs
