#include "lrcs/facet_sections.h"

#include "lrcs/convex_body.h"

namespace lrcs {

const CrossSection& FacetSections::at(const Aspect& aspect, VisibilityCost* cost) {
  const Vec3 &di = aspect.to_transmitter, &dr = aspect.to_receiver;
  auto& [seen, parts, section] = memory_.local();
  SeenParts* const of_aspect = visibility_ == nullptr || target_.curved.empty() ? nullptr : &parts;
  if (visibility_ == nullptr)
    seen = convex_seen_fraction(target_.mesh, di, dr);
  else
    visibility_->seen_fraction(di, dr, seen, cost, of_aspect);
  cross_section(target_, seen, di, dr, section, of_aspect);
  return section;
}

}  // namespace lrcs
