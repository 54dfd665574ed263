#include "lrcs/solids.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "lrcs/facet_frame.h"
#include "lrcs/layer_query.h"
#include "mesh/disjoint_sets.h"

namespace lrcs {
namespace {

class SolidSearch {
 public:
  SolidSearch(const Occluders& occluders, const FacetTree& tree, const OccluderEdges& edges, const Contacts& contacts)
      : occluders_(occluders),
        tree_(tree),
        edges_(edges),
        contacts_(contacts),
        pieces_(occluders.size()),
        sheets_(pieces_),
        broken_(occluders.size(), 0) {}

  std::vector<std::uint8_t> solid_facets() {
    join_sheets();
    break_open_pieces();
    join_open_pieces();
    break_open_pieces();
    break_pieces_that_meet_themselves();
    break_pieces_wound_backward();
    std::vector<std::uint8_t> solid(occluders_.size());
    for (std::uint32_t f = 0; f < occluders_.size(); ++f) solid[f] = broken_[pieces_.root(f)] != 0 ? 0 : 1;
    return solid;
  }

 private:
  // Calls visit(facets) for every edge.
  template <class Visit>
  void for_each_edge(const Visit& visit) {
    for (std::uint32_t e = 0; e < edges_.edges().size(); ++e) visit(edges_.facets_at(e));
  }

  // Sheets are connected across edges of two facets of one winding.
  void join_sheets() {
    for_each_edge([&](std::span<const FacetAtEdge> uses) {
      if (uses.size() == 2 && uses[0].rising != uses[1].rising) sheets_.join(uses[0].facet, uses[1].facet);
    });
    pieces_ = sheets_;
  }

  // Sheets that are not closed by themselves may be so together, across edges of more facets.
  void join_open_pieces() {
    for_each_edge([&](std::span<const FacetAtEdge> uses) {
      const FacetAtEdge* first = nullptr;
      for (const FacetAtEdge& use : uses) {
        if (broken_[sheets_.root(use.facet)] == 0) continue;
        if (first != nullptr) pieces_.join(first->facet, use.facet);
        first = &use;
      }
    });
    std::fill(broken_.begin(), broken_.end(), 0);
  }

  void mark(std::uint32_t facet) { broken_[pieces_.root(facet)] = 1; }

  // Those whose windings do not cancel at one of their edges.
  void break_open_pieces() {
    std::vector<std::uint8_t> open(broken_.size(), 0);
    for_each_edge([&](std::span<const FacetAtEdge> uses) {
      for (const FacetAtEdge& use : uses) {
        int balance = 0;
        for (const FacetAtEdge& other : uses)
          if (pieces_.root(other.facet) == pieces_.root(use.facet)) balance += other.rising ? 1 : -1;
        if (balance != 0) open[pieces_.root(use.facet)] = 1;
      }
    });
    broken_ = std::move(open);
  }

  // What only touches itself is left out too: two strands may cross along an edge of both.
  void break_pieces_that_meet_themselves() {
    for (std::uint32_t f = 0; f < occluders_.size(); ++f) {
      if (!contacts_.any(f)) continue;
      const auto of = contacts_.of(f);
      const auto meets = [&](std::uint32_t other) {
        if (pieces_.root(other) == pieces_.root(f)) mark(f);
      };
      for (const auto& passage : of.passages) meets(passage.facet);
      for (const auto& lying : of.edges)
        for (const FacetAtEdge& use : edges_.facets_at(lying.edge)) meets(use.facet);
      for (const std::uint32_t other : of.coplanar) meets(other);
    }
  }

  // How often a piece winds around what lies before a facet is the same all over a sheet that meets its piece nowhere.
  void break_pieces_wound_backward() {
    for (std::uint32_t f = 0; f < occluders_.size(); ++f)
      if (sheets_.root(f) == f && broken_[pieces_.root(f)] == 0) {
        const auto wound = windings_before(f);
        if (!wound || *wound < 0) mark(f);
      }
  }

  // Fronts less backs of the facet's own piece that stand before it; nothing where no line of sight tells for certain.
  std::optional<int> windings_before(std::uint32_t facet) {
    const Vec3 normal = occluders_.cross[facet].stableNormalized();
    const Vec3 aside = normal.unitOrthogonal();
    constexpr std::array<double, 3> tilts{0.0, 0.31, -0.17};
    for (const double tilt : tilts) {
      const Vec3 toward = (normal + tilt * aside + 0.5 * tilt * normal.cross(aside)).normalized();
      const LayerQuery query(occluders_, tree_, ViewFrame(toward, occluders_.centre));
      const auto facing = [&](std::uint32_t other) {
        if (pieces_.root(other) != pieces_.root(facet)) return 0;
        if (FacetFrame::edge_on(occluders_.cross[other], toward) != FacetFrame::EdgeOn::no) return 0;
        return occluders_.cross[other].dot(toward) > 0.0 ? 1 : -1;
      };
      if (const auto before = query.count(facet, 0.31, 0.36, facing)) return before->windings;
    }
    return std::nullopt;
  }

  const Occluders& occluders_;
  const FacetTree& tree_;
  const OccluderEdges& edges_;
  const Contacts& contacts_;
  DisjointSets pieces_, sheets_;
  std::vector<std::uint8_t> broken_;  // by a piece's root (of open sheets: a sheet's): it is no solid
};

}  // namespace

std::vector<std::uint8_t> solid_facets(const Occluders& occluders, const FacetTree& tree, const OccluderEdges& edges,
                                       const Contacts& contacts) {
  return SolidSearch(occluders, tree, edges, contacts).solid_facets();
}

}  // namespace lrcs
