#pragma once
#include <tbb/enumerable_thread_specific.h>

#include "lrcs/aspect.h"
#include "lrcs/cross_section.h"
#include "lrcs/seen_parts.h"
#include "lrcs/visibility.h"

namespace lrcs {

// The exact cross sections of a target with the share of every facet, one aspect after another.
class FacetSections {
 public:
  // visibility: of the target's mesh; null: the target is a convex body. All must outlive this.
  FacetSections(const Target& target, const Visibility* visibility) : target_(target), visibility_(visibility) {}

  // Valid until the same thread asks again. Safe to call from several threads at once.
  // law: the same bytes for any number of threads.
  [[nodiscard]] const CrossSection& at(const Aspect& aspect, VisibilityCost* cost = nullptr);

 private:
  struct Memory {  // of a thread
    std::vector<Estimate> seen;
    SeenParts parts;
    CrossSection section;
  };

  const Target& target_;
  const Visibility* visibility_;
  tbb::enumerable_thread_specific<Memory> memory_;
};

}  // namespace lrcs
