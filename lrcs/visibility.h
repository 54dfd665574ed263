#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/estimate.h"
#include "base/vec3.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

class SeenParts;
struct Surface;

// What it took to find the seen fractions for one pair of directions.
struct VisibilityCost {
  std::size_t cut = 0;      // facets over which an outline runs
  std::size_t hidden = 0;   // facets that a coarse look tells to be hidden
  std::size_t queries = 0;  // places where layers were counted one by one
  std::size_t clipped = 0;  // facets settled by clipping alone
  // Parts that nothing else stood before, by viewer (lrcs/free_parts.h).
  std::size_t free_convex_parts = 0;
  std::size_t other_free_parts = 0;
};

// Which part of every facet the transmitter lights AND the receiver sees, exactly.
//
// The number of layers in front of a facet changes only across outlines (folds, boundaries, cuts), and is counted by
// walking over the surface (lrcs/layer_walk.h); where that leaves a doubt, the facet is clipped against all that stands
// before it (lrcs/facet_view.h). Nothing is asked of the mesh: open, non-manifold, self-intersecting targets and any
// number of parts are alike. Which side of a facet's plane a vertex lies on is decided exactly (lrcs/exact_height.h).
// domain: finite coordinates; unit directions. Coincident facets count once: the one whose front is seen, then the
// lower index. error: Estimate::bound, a few units in the last place times the facet's foreshortening and the reach of
// what is before it; 0 for facets that no outline comes near. check: against the straight way, closed forms, rays and
// metamorphic laws in tests/lrcs.
class Visibility {
 public:
  // Copies the geometry and builds what does not depend on directions.
  explicit Visibility(const FacetMesh& mesh);
  ~Visibility();

  // Leaves out the facets that count for none of the viewers (unit vectors toward them) and returns their number; 0,
  // and nothing is done, where there are too few of either to make up for it. domain of seen_fraction() from then on:
  // those viewers. Not while another thread is at work.
  std::size_t look_only_from(std::span<const Vec3> viewers);
  // Facets on the target's convex hull (lrcs/hull_facets.h).
  [[nodiscard]] std::size_t hull_facets() const;

  // value: fraction 0..1 of the facet's area that is lit from to_transmitter and seen from to_receiver (equal:
  // monostatic). shape: one a facet. A facet whose two sides face the one and the other, or that is seen edge-on, has
  // fraction 0. Safe to call from several threads at once; the result does not depend on their number.
  [[nodiscard]] std::vector<Estimate> seen_fraction(const Vec3& to_transmitter, const Vec3& to_receiver,
                                                    VisibilityCost* cost = nullptr) const;
  // Into memory that is there already: for many facets it takes long to be had anew. Of a mesh with curved facets, with
  // what is seen of those that are seen in part and turn, where that is known better than by its fraction.
  void seen_fraction(const Vec3& to_transmitter, const Vec3& to_receiver, std::vector<Estimate>& fraction,
                     VisibilityCost* cost = nullptr, SeenParts* parts = nullptr) const;

  // The same by clipping every facet: slow, the oracle for tests.
  [[nodiscard]] std::vector<Estimate> seen_fraction_by_clipping(const Vec3& to_transmitter,
                                                                const Vec3& to_receiver) const;

  // Pairs of facets that lie in one plane, one on the other or nearly so, as numbers of the mesh: only there does the
  // result hang on the order of facets.
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> coincident_facets() const;

 private:
  struct Scratch;  // a thread's memory, used again from direction to direction

  std::size_t facets_ = 0;
  std::unique_ptr<const Surface> surface_;
  mutable tbb::enumerable_thread_specific<std::unique_ptr<Scratch>> scratch_;
};

}  // namespace lrcs
