#pragma once
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "brdf/retro_form.h"
#include "lrcs/aspect.h"
#include "lrcs/cross_section.h"
#include "lrcs/facet_block.h"

namespace lrcs {

// A convex target, in blocks of facets: its cross section with no visibility to be found.
// A block stays in the cache while all directions asked for together pass over it, and is left out where all its facets
// are turned away (facets of like normals are in one block).
class ConvexBody {
 public:
  // domain: is_convex_body(target.mesh), lrcs/convexity.h. Refers to the target.
  explicit ConvexBody(const Target& target);

  struct Section {
    Estimate sigma;          // [m^2]
    double seen_area = 0.0;  // [m^2]
  };
  // What cross_section() finds (lrcs/cross_section.h), without the facets' shares. shape: one an aspect.
  // laws: the same bytes for an aspect whatever others are asked with it, and on any machine.
  // error: sigma.bound; that of an aspect by itself is 640 u 4 pi Sum f cos_i cos_r A / min(cos_i, cos_r) and the
  // pair's
  //   (docs/methods.md, section 6), u = 2^-53. check: tests/lrcs/convex_body_test.cpp.
  // faced: set to 1 for blocks that some aspect faces; others are left as they are. shape: one a block.
  [[nodiscard]] std::vector<Section> sections(std::span<const Aspect> aspects, std::vector<std::uint8_t>& faced) const;

  [[nodiscard]] std::size_t blocks() const { return blocks_.size(); }
  [[nodiscard]] std::size_t facets_of(std::size_t block) const { return blocks_[block].facets; }

 private:
  struct Sums;
  using Retro = std::variant<BlackRetro, LambertRetro, WuRetro, const Brdf*>;

  void add_monostatic(const FacetBlock& block, const Vec3& d, LaneSums& sums) const;
  void add_bistatic(const FacetBlock& block, const Aspect& aspect, Sums& sums, LaneSums& lanes) const;

  const Target& target_;
  std::vector<FacetBlock> blocks_;
  std::vector<Retro> retro_;  // one a material
};

// The seen fractions of a convex target: what Visibility::seen_fraction() finds of it. shape: one a facet.
// value: 1 where the fronts face both ways, with bound 0; 0 with bound 1 where rounding cannot tell.
[[nodiscard]] std::vector<Estimate> convex_seen_fraction(const FacetMesh& mesh, const Vec3& to_transmitter,
                                                         const Vec3& to_receiver);

}  // namespace lrcs
