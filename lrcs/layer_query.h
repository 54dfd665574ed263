#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "lrcs/surface.h"
#include "lrcs/view_outline.h"

namespace lrcs {

// The number of layers in front of a place on a facet, counted one by one along a line to the viewer.
class LayerQuery {
 public:
  LayerQuery(const Surface& surface, const ViewOutline& view) : surface_(surface), view_(view) {}

  // `place`: inside the facet. Nothing where rounding could change the answer: try another place.
  [[nodiscard]] std::optional<int> layers_over(std::uint32_t facet, const Vec3& place) const;

 private:
  enum class Answer { no, yes, unsure };
  [[nodiscard]] Answer is_before(std::uint32_t other, std::uint32_t facet, const Vec3& seen_place) const;
  [[nodiscard]] Answer is_before_by_planes(std::uint32_t other, std::uint32_t facet) const;

  const Surface& surface_;
  const ViewOutline& view_;
};

}  // namespace lrcs
