#include "lrcs/solids.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>

#include "lrcs/facet_frame.h"
#include "lrcs/layer_query.h"

namespace lrcs {
namespace {

// Disjoint sets of facets.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t root(std::uint32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// A member of the surface at an edge: a facet, or one of area zero (numbered after the facets), which closes gaps.
struct Use {
  std::uint32_t member;
  bool rising;
};

class SolidSearch {
 public:
  SolidSearch(const Occluders& occluders, const FacetTree& tree, const OccluderEdges& edges, const Contacts& contacts)
      : occluders_(occluders),
        tree_(tree),
        edges_(edges),
        contacts_(contacts),
        pieces_(occluders.size() + occluders.collinear.size()),
        sheets_(pieces_),
        broken_(occluders.size() + occluders.collinear.size(), 0) {}

  std::vector<std::uint8_t> solid_facets() {
    find_sides_of_collinear();
    join_sheets();
    break_open_pieces();
    join_open_pieces();
    break_open_pieces();
    break_pieces_that_pass_themselves();
    break_pieces_wound_backward();
    std::vector<std::uint8_t> solid(occluders_.size());
    for (std::uint32_t f = 0; f < occluders_.size(); ++f) solid[f] = broken_[pieces_.root(f)] != 0 ? 0 : 1;
    return solid;
  }

 private:
  static std::uint64_t key_of(std::uint32_t low, std::uint32_t high) { return std::uint64_t{low} << 32U | high; }

  void find_sides_of_collinear() {
    for (std::uint32_t c = 0; c < occluders_.collinear.size(); ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = occluders_.collinear[c][k], b = occluders_.collinear[c][(k + 1) % 3];
        const auto member = static_cast<std::uint32_t>(occluders_.size()) + c;
        collinear_at_[key_of(std::min(a, b), std::max(a, b))].push_back({member, a < b});
      }
  }

  // Calls visit(uses) for every edge.
  template <class Visit>
  void for_each_edge(const Visit& visit) {
    std::vector<Use> uses;
    for (std::uint32_t e = 0; e < edges_.edges().size(); ++e) {
      uses.clear();
      for (const FacetAtEdge& use : edges_.facets_at(e)) uses.push_back({use.facet, use.rising});
      if (!collinear_at_.empty()) {
        const auto more = collinear_at_.find(key_of(edges_.edges()[e].low, edges_.edges()[e].high));
        if (more != collinear_at_.end()) uses.insert(uses.end(), more->second.begin(), more->second.end());
      }
      visit(uses);
    }
    for (const auto& [key, at_edge] : collinear_at_)
      if (!edges_.find(static_cast<std::uint32_t>(key >> 32U), static_cast<std::uint32_t>(key))) visit(at_edge);
  }

  // Sheets are connected across edges of two facets of one winding.
  void join_sheets() {
    for_each_edge([&](const std::vector<Use>& uses) {
      if (uses.size() == 2 && uses[0].rising != uses[1].rising) sheets_.join(uses[0].member, uses[1].member);
    });
    pieces_ = sheets_;
  }

  // Sheets that are not closed by themselves may be so together, across edges of more facets.
  void join_open_pieces() {
    for_each_edge([&](const std::vector<Use>& uses) {
      const Use* first = nullptr;
      for (const Use& use : uses) {
        if (broken_[sheets_.root(use.member)] == 0) continue;
        if (first != nullptr) pieces_.join(first->member, use.member);
        first = &use;
      }
    });
    std::fill(broken_.begin(), broken_.end(), 0);
  }

  void mark(std::uint32_t member) { broken_[pieces_.root(member)] = 1; }

  // Those whose windings do not cancel at one of their edges.
  void break_open_pieces() {
    std::vector<std::uint8_t> open(broken_.size(), 0);
    for_each_edge([&](const std::vector<Use>& uses) {
      for (const Use& use : uses) {
        int balance = 0;
        for (const Use& other : uses)
          if (pieces_.root(other.member) == pieces_.root(use.member)) balance += other.rising ? 1 : -1;
        if (balance != 0) open[pieces_.root(use.member)] = 1;
      }
    });
    broken_ = std::move(open);
  }

  void break_pieces_that_pass_themselves() {
    for (std::uint32_t f = 0; f < occluders_.size(); ++f) {
      if (!contacts_.any(f)) continue;
      for (const auto& passage : contacts_.of(f).passages)
        if (pieces_.root(passage.facet) == pieces_.root(f)) mark(f);
    }
  }

  // How often a piece winds around what lies before a facet is the same all over a sheet of it.
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
      const Vec3 place = FacetFrame(occluders_, facet).place(0.31, 0.36);
      if (const auto before = query.count(facet, place, facing)) return before->windings;
    }
    return std::nullopt;
  }

  const Occluders& occluders_;
  const FacetTree& tree_;
  const OccluderEdges& edges_;
  const Contacts& contacts_;
  Sets pieces_, sheets_;
  std::vector<std::uint8_t> broken_;  // by a piece's root (of open sheets: a sheet's): it is no solid
  std::map<std::uint64_t, std::vector<Use>> collinear_at_;
};

}  // namespace

std::vector<std::uint8_t> solid_facets(const Occluders& occluders, const FacetTree& tree, const OccluderEdges& edges,
                                       const Contacts& contacts) {
  return SolidSearch(occluders, tree, edges, contacts).solid_facets();
}

}  // namespace lrcs
