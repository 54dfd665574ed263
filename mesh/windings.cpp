#include "mesh/windings.h"

#include <algorithm>

#include "mesh/facet_lists.h"
#include "mesh/winding_sets.h"

namespace lrcs {
namespace {

// How many of a piece's facets face as its root and how many do not, and which way its first one faces.
struct Sides {
  std::size_t same = 0, opposite = 0;
  bool first_is_opposite = false;

  [[nodiscard]] bool keeps_opposite() const { return opposite > same || (opposite == same && first_is_opposite); }
};

}  // namespace

std::vector<std::uint32_t> facets_against_most(const FacetMesh& welded) {
  WindingSets sets(welded.size());
  for (const auto& part : facets_of_parts(welded)) sets.join_at_manifold_edges(Edges(welded, part));
  std::vector<Sides> pieces(welded.size());  // by root
  for (std::uint32_t k = 0; k < welded.size(); ++k) {
    Sides& piece = pieces[sets.root(k)];
    if (piece.same + piece.opposite == 0) piece.first_is_opposite = sets.is_opposite(k);
    ++(sets.is_opposite(k) ? piece.opposite : piece.same);
  }
  std::vector<std::uint32_t> against;
  for (std::uint32_t k = 0; k < welded.size(); ++k)
    if (!sets.is_torn(k) && sets.is_opposite(k) != pieces[sets.root(k)].keeps_opposite()) against.push_back(k);
  return against;
}

}  // namespace lrcs
