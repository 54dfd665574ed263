#pragma once
#include <cstdint>
#include <vector>

#include "lrcs/surface.h"
#include "lrcs/view_outline.h"

namespace lrcs {

// The parts that nothing else stands before, as seen along one direction, and the facets seen whole for that reason.
// A part is free if its box in the view meets none that reaches in front of it, rounding included. What stands before
// its facets is its own, then, and before those on its hull is nothing: of a convex part that is all that faces the
// viewer. So it is for facets on the target's hull, free or not (lrcs/hull_facets.h).
// law: what is said to have nothing before it has nothing before it, exactly.
// One object a thread; its memory is used again from direction to direction. check: tests/lrcs/free_parts_test.cpp.
class FreeParts {
 public:
  // Refers to the surface.
  explicit FreeParts(const Surface& surface);

  void look_at(const ViewOutline& view);

  // facing: of the facet, in that view.
  [[nodiscard]] bool nothing_before(std::uint32_t facet, int facing) const {
    return surface_->hull.nothing_before(facet, facing) ||
           (!free_.empty() && surface_->hull.nothing_of_its_part_before(facet, facing) &&
            free_[surface_->parts.of(facet)] != 0);
  }
  // Is the facet one of a convex part that is free? All of it that faces the viewer is seen whole.
  [[nodiscard]] bool is_seen_whole(std::uint32_t facet) const {
    const std::uint32_t part = surface_->parts.of(facet);
    return !free_.empty() && free_[part] != 0 && surface_->parts.is_convex(part);
  }
  // Of the last view. Parts without a facet on their hull but not on the target's do not count: there is nothing to
  // gain.
  [[nodiscard]] std::size_t free_convex_parts() const { return free_convex_; }
  [[nodiscard]] std::size_t other_free_parts() const { return other_free_; }

 private:
  struct SeenPart {
    double left, right, bottom, top, far, near;
    std::uint32_t part;
  };

  void find_boxes(const ViewOutline& view);
  void sweep();
  void count();

  const Surface* surface_;
  std::vector<std::uint8_t> may_gain_;  // one a part
  bool any_gain_ = false;
  std::vector<SeenPart> boxes_, open_;
  std::vector<std::uint8_t> free_;  // one a part, or none: not looked for
  std::size_t free_convex_ = 0, other_free_ = 0;
};

}  // namespace lrcs
