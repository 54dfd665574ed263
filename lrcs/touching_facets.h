#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "lrcs/cross_section.h"

namespace lrcs {

class EmbreeScene;

// Facets on which another lies, or nearly: rays in floats may meet either. Sought only where that matters: where the
// target has facets of different materials, or backs that return nothing.
// method: from four points of every facet short rays to both sides. A facet that covers less of another than lies
// between such points may go unnoticed; it is found from its own.
class TouchingFacets {
 public:
  // Keeps references.
  TouchingFacets(const Target& target, const EmbreeScene& scene);

  [[nodiscard]] bool none() const { return none_; }
  // Does another one lie at this place of the facet? In the scene's frame.
  [[nodiscard]] bool any_at(std::uint32_t facet, const Vec3& place) const {
    return !touched_.empty() && touched_[facet] != 0 && facet_at(facet, place) != nothing;
  }

 private:
  static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

  void probe(std::uint32_t facet);
  [[nodiscard]] std::uint32_t facet_at(std::uint32_t facet, const Vec3& place) const;

  const FacetMesh& mesh_;
  const EmbreeScene& scene_;
  bool none_ = true;
  std::vector<std::uint8_t> touched_;  // one a facet, or none
};

}  // namespace lrcs
