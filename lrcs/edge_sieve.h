#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lrcs/seen_facet.h"
#include "lrcs/view_outline.h"

namespace lrcs {

// The ends of outline edges in a view, rounded to floats, an array for each coordinate.
struct EdgeEnds {
  // Edges looked at together, whatever the machine's vectors hold; so many more places than edges.
  static constexpr std::size_t lanes = 16;
  std::vector<float> low_x, low_y, low_z, high_x, high_y, high_z;
  std::vector<std::uint32_t> edge;  // number in the outline

  void resize(std::size_t edges);
  void put(std::size_t place, const OutlineEdge& outline_edge, std::uint32_t number);
};

// The first and quickest look at many outline edges over one facet: most are far beside it, or behind its plane.
// What it does not rule out, FacetSight looks at more closely.
// law: never rules out what has a part over the facet and in front of it.
class EdgeSieve {
 public:
  // `rounding`: of the view. `reach`: no coordinate in the view is larger.
  void look_at(const SeenFacet& facet, double rounding, double reach);
  // A quicker look still, for few edges: at boxes alone.
  void look_at_box(const SeenFacet& facet, double rounding, double reach);

  // Appends the numbers of those among the ends [first, last) that may matter.
  void sift(const EdgeEnds& ends, std::size_t first, std::size_t last, std::vector<std::uint32_t>& found);
  void sift_boxes(const EdgeEnds& ends, std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) const;

  // u, v and the height over the facet's plane as functions of x, y and z; and errors, all of floats.
  struct Facet {
    float left, right, bottom, top, far;
    float u_x, u_y, u_0, v_x, v_y, v_0, slack;
    float h_x, h_y, h_0, height_slack;
  };

 private:
  Facet facet_{};
  std::vector<std::int32_t> may_matter_;
};

}  // namespace lrcs
