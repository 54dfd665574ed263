#include "lrcs/free_parts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lrcs {

FreeParts::FreeParts(const Surface& surface) : surface_(&surface) {
  const std::size_t parts = surface.parts.size(), facets = surface.occluders.size();
  // Of parts of fewer facets, finding which are free takes longer than it saves.
  constexpr std::size_t few = 4;
  if (parts < 2 || few * parts > facets) return;
  may_gain_.assign(parts, 0);
  for (std::uint32_t f = 0; f < facets; ++f)
    if (surface.hull.is_on_hull_of_its_part_only(f)) may_gain_[surface.parts.of(f)] = 1;
  any_gain_ = std::ranges::count(may_gain_, 1) > 0;
}

void FreeParts::look_at(const ViewOutline& view) {
  free_convex_ = other_free_ = 0;
  if (!any_gain_) return;
  free_ = may_gain_;  // until something is found before it
  find_boxes(view);
  sweep();
  count();
}

// Wider by more than what the view's coordinates are off by.
void FreeParts::find_boxes(const ViewOutline& view) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double *x = view.x(), *y = view.y(), *z = view.z(), margin = 2.0 * view.rounding();
  boxes_.clear();
  for (std::uint32_t part = 0; part < surface_->parts.size(); ++part) {
    if (surface_->parts.vertices(part).empty()) continue;
    SeenPart box{infinity, -infinity, infinity, -infinity, infinity, -infinity, part};
    for (const std::uint32_t v : surface_->parts.vertices(part)) {
      box.left = std::min(box.left, x[v]), box.right = std::max(box.right, x[v]);
      box.bottom = std::min(box.bottom, y[v]), box.top = std::max(box.top, y[v]);
      box.far = std::min(box.far, z[v]), box.near = std::max(box.near, z[v]);
    }
    boxes_.push_back({box.left - margin, box.right + margin, box.bottom - margin, box.top + margin, box.far - margin,
                      box.near + margin, part});
  }
}

// From left to right, or from bottom to top where that keeps fewer parts side by side.
void FreeParts::sweep() {
  double widths = 0.0, heights = 0.0;
  for (const SeenPart& p : boxes_) {
    widths += p.right - p.left;
    heights += p.top - p.bottom;
  }
  if (heights < widths)
    for (SeenPart& p : boxes_) {
      std::swap(p.left, p.bottom);
      std::swap(p.right, p.top);
    }
  std::ranges::sort(boxes_, {}, &SeenPart::left);
  open_.clear();
  for (const SeenPart& p : boxes_) {
    for (std::size_t k = 0; k < open_.size();) {
      const SeenPart& other = open_[k];
      if (other.right < p.left) {
        open_[k] = open_.back();
        open_.pop_back();
        continue;
      }
      ++k;
      if (other.top < p.bottom || p.top < other.bottom) continue;
      if (other.near >= p.far) free_[p.part] = 0;
      if (p.near >= other.far) free_[other.part] = 0;
    }
    open_.push_back(p);
  }
}

void FreeParts::count() {
  for (std::uint32_t part = 0; part < free_.size(); ++part)
    if (free_[part] != 0) ++(surface_->parts.is_convex(part) ? free_convex_ : other_free_);
}

}  // namespace lrcs
