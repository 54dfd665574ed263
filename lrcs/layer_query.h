#pragma once
#include <cstdint>
#include <functional>
#include <optional>

#include "lrcs/facet_tree.h"
#include "lrcs/occluders.h"

namespace lrcs {

// What stands before a place on a facet, counted facet by facet along a line to the viewer.
class LayerQuery {
 public:
  LayerQuery(const Occluders& occluders, const FacetTree& tree, const ViewFrame& view);

  // Which way a facet faces the viewer, +1 or -1; 0: leave it out (whatever is edge-on must be).
  using Facing = std::function<int(std::uint32_t)>;
  struct Before {
    int layers = 0;    // facets
    int windings = 0;  // those whose front is seen less those whose back is
  };
  // (u, v): the place inside the facet (FacetFrame). Nothing where rounding could change the answer: try another place.
  [[nodiscard]] std::optional<Before> count(std::uint32_t facet, double u, double v, const Facing& facing) const;

 private:
  enum class Answer { no, yes, unsure };
  [[nodiscard]] Answer is_before(std::uint32_t other, int other_facing, std::uint32_t facet, const Vec3& place) const;
  [[nodiscard]] Answer is_before_by_planes(std::uint32_t other, int other_facing, std::uint32_t facet) const;

  const Occluders& occluders_;
  const FacetTree& tree_;
  ViewFrame view_;
  Vec3 inverse_;  // of the direction
};

}  // namespace lrcs
