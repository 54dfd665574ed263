#pragma once
#include <cstdint>
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
  TouchingFacets(const Target& target, const EmbreeScene& scene);

  [[nodiscard]] bool none() const { return none_; }
  [[nodiscard]] bool any(std::uint32_t facet) const { return !touched_.empty() && touched_[facet] != 0; }

 private:
  void probe(std::uint32_t facet, const EmbreeScene& scene);

  const FacetMesh& mesh_;
  bool none_ = true;
  std::vector<std::uint8_t> touched_;  // one a facet, or none
};

}  // namespace lrcs
