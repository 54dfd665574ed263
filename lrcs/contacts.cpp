#include "lrcs/contacts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "lrcs/facet_frame.h"
#include "lrcs/unit_triangle.h"

namespace lrcs {
namespace {

struct Found {  // for one facet
  std::uint32_t facet;
  std::vector<Contacts::Passage> passages;
  std::vector<std::uint32_t> lying;  // edges
  std::vector<std::uint32_t> coplanar;
  [[nodiscard]] bool any() const { return !coplanar.empty() || !passages.empty() || !lying.empty(); }
};

struct Corner {
  std::uint32_t vertex;
  FacetPoint at;
  int shared;  // the facet's own corner that it is, -1: none
  unsigned beyond;
};

int sign(double x) {
  return x > 0.0 ? 1 : x < 0.0 ? -1 : 0;
}

class ContactSearch {
 public:
  ContactSearch(const Occluders& occluders, const OccluderEdges& edges, std::uint32_t facet)
      : occluders_(occluders), edges_(edges), frame_(occluders, facet) {
    found_.facet = facet;
    frame_.turn_to_front();
  }

  void look_at(std::uint32_t other) {
    std::array<Corner, 3> corners{};
    double reach = 0.0;
    for (const auto v : occluders_.facets[other]) reach = std::max(reach, frame_.reach(v));
    slack_ = frame_.rounding(reach);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = occluders_.facets[other][k];
      corners[k] = {v, frame_.at_vertex(v), frame_.corner(v), 0};
      corners[k].beyond = sides_beyond(corners[k].at, corners[k].shared, slack_);
    }
    if ((corners[0].beyond & corners[1].beyond & corners[2].beyond) != 0) return;
    int zeros = 0, front = 0;
    for (Corner& c : corners) {
      if (!c.at.sign_is_certain()) frame_.refine(c.at, c.vertex);
      zeros += c.at.height == 0.0 ? 1 : 0;
      front += c.at.height > 0.0 ? 1 : 0;
    }
    const bool passes = front > 0 && front + zeros < 3;
    if (zeros == 3 && !lies_beside(corners)) found_.coplanar.push_back(other);
    if (zeros >= 2) add_lying_edges(other, corners);
    if (passes) add_passage(other, corners);
  }

  [[nodiscard]] Found take() {
    std::sort(found_.lying.begin(), found_.lying.end());
    found_.lying.erase(std::unique(found_.lying.begin(), found_.lying.end()), found_.lying.end());
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool apart(const Corner& a, const Corner& b) const {
    return (a.beyond & b.beyond) != 0 || line_passes_by(a.at, a.shared, b.at, b.shared, slack_);
  }

  // For a facet in the plane: does one of its sides certainly part it from this one?
  [[nodiscard]] bool lies_beside(const std::array<Corner, 3>& corners) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
      const bool left = side_of_line(a.at, b.at, c.at.u, c.at.v) > 0.0;
      if (line_passes_by(a.at, a.shared, b.at, b.shared, slack_, left ? Beside::right : Beside::left)) return true;
    }
    return are_parted_at_corner(corners);
  }

  // For a facet that shares one corner: does the line through it across their middles' difference part the two?
  [[nodiscard]] bool are_parted_at_corner(const std::array<Corner, 3>& corners) const {
    const auto is_shared = [](const Corner& c) { return c.shared >= 0; };
    if (std::count_if(corners.begin(), corners.end(), is_shared) != 1) return false;
    const Corner& corner = *std::find_if(corners.begin(), corners.end(), is_shared);
    double u = -1.0 / 3.0, v = -1.0 / 3.0;
    for (const Corner& c : corners) {
      u += c.at.u / 3.0;
      v += c.at.v / 3.0;
    }
    // The difference (u, v) points to the right of this line.
    const FacetPoint on_line{corner.at.u - v, corner.at.v + u, 0.0, 0.0};
    const double length = std::abs(u) + std::abs(v);
    const auto is_beyond = [&](const Corner& c) {
      const double reach = 1.0 + std::abs(c.at.u) + std::abs(c.at.v);
      return c.shared >= 0 || side_of_line(corner.at, on_line, c.at.u, c.at.v) < -4.0 * slack_ * (1.0 + length) * reach;
    };
    return std::all_of(corners.begin(), corners.end(), is_beyond) &&
           line_passes_by(corner.at, corner.shared, on_line, -1, slack_, Beside::left);
  }

  void add_lying_edges(std::uint32_t other, const std::array<Corner, 3>& corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &a = corners[k], &b = corners[(k + 1) % 3];
      if (a.at.height == 0.0 && b.at.height == 0.0 && !apart(a, b)) found_.lying.push_back(edges_.edge_of(other, k));
    }
  }

  void add_passage(std::uint32_t other, const std::array<Corner, 3>& corners) {
    Contacts::Passage passage{other, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
      const int sa = sign(a.at.height), sb = sign(b.at.height), sc = sign(c.at.height);
      const Contacts::Place between{std::min(a.vertex, b.vertex), std::max(a.vertex, b.vertex)};
      if (sa == 0) (sc > 0 ? passage.leaves : passage.enters) = {a.vertex, a.vertex};
      if (sa > 0 && sb < 0) passage.leaves = between;
      if (sa < 0 && sb > 0) passage.enters = between;
    }
    double error_leaves = 0.0, error_enters = 0.0;
    const FacetPoint leaves = frame_.passage(passage.leaves.low, passage.leaves.high, error_leaves);
    const FacetPoint enters = frame_.passage(passage.enters.low, passage.enters.high, error_enters);
    const double slack = std::max(error_leaves, error_enters);
    if ((sides_beyond(leaves, corner(passage.leaves), slack) & sides_beyond(enters, corner(passage.enters), slack)) !=
        0)
      return;
    if (line_passes_by(leaves, corner(passage.leaves), enters, corner(passage.enters), slack)) return;
    found_.passages.push_back(passage);
  }

  [[nodiscard]] int corner(const Contacts::Place& place) const {
    return place.low == place.high ? frame_.corner(place.low) : -1;
  }

  const Occluders& occluders_;
  const OccluderEdges& edges_;
  FacetFrame frame_;
  double slack_ = 0.0;
  Found found_;
};

Box3 box_of(const Occluders& occluders, std::uint32_t facet) {
  const auto& f = occluders.facets[facet];
  const Vec3 &a = occluders.positions[f[0]], &b = occluders.positions[f[1]], &c = occluders.positions[f[2]];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

// A box with all places that the facet's own coordinates do not tell from places on it.
Box3 wider_box_of(const Occluders& occluders, std::uint32_t facet, double reach) {
  FacetFrame frame(occluders, facet);
  frame.turn_to_front();
  const double margin = 8.0 * frame.rounding(reach) * frame.own_reach();
  const Box3 box = box_of(occluders, facet);
  return {box.low.array() - margin, box.high.array() + margin};
}

void search_leaf(const Occluders& occluders, const FacetTree& tree, const OccluderEdges& edges,
                 const FacetTree::Node& leaf, std::vector<Found>& found) {
  std::vector<Box3> own;
  Box3 all = leaf.box;
  for (std::uint32_t f = leaf.first; f < leaf.last; ++f) {
    own.push_back(wider_box_of(occluders, f, tree.reach()));
    all = {all.low.cwiseMin(own.back().low), all.high.cwiseMax(own.back().high)};
  }
  std::vector<std::uint32_t> near;
  tree.overlapping(all, near);
  std::vector<Box3> boxes;
  boxes.reserve(near.size());
  for (const std::uint32_t f : near) boxes.push_back(box_of(occluders, f));
  for (std::uint32_t f = leaf.first; f < leaf.last; ++f) {
    ContactSearch search(occluders, edges, f);
    for (std::size_t k = 0; k < near.size(); ++k)
      if (near[k] != f && overlap(own[f - leaf.first], boxes[k])) search.look_at(near[k]);
    Found of_facet = search.take();
    if (of_facet.any()) found.push_back(std::move(of_facet));
  }
}

// +1, -1, 0 for a facet at an edge in the plane of another one: on which side of that plane its third corner lies.
std::int8_t side_of(const Occluders& occluders, const FacetFrame& frame, const OccluderEdges::Edge& edge,
                    std::uint32_t facet) {
  for (const std::uint32_t v : occluders.facets[facet]) {
    if (v == edge.low || v == edge.high) continue;
    FacetPoint p = frame.at_vertex(v);
    if (!p.sign_is_certain()) frame.refine(p, v);
    return static_cast<std::int8_t>(sign(p.height));
  }
  return 0;
}

}  // namespace

Contacts::Contacts(const Occluders& occluders, const FacetTree& tree, const OccluderEdges& edges)
    : place_(occluders.size(), none) {
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t k = 0; k < tree.nodes().size(); ++k)
    if (tree.nodes()[k].leaf) leaves.push_back(k);
  std::vector<std::vector<Found>> found(leaves.size());
  tbb::parallel_for(std::size_t{0}, leaves.size(),
                    [&](std::size_t k) { search_leaf(occluders, tree, edges, tree.nodes()[leaves[k]], found[k]); });
  for (const auto& of_leaf : found)
    for (const Found& of_facet : of_leaf) {
      place_[of_facet.facet] = static_cast<std::uint32_t>(begins_.size());
      facets_.push_back(of_facet.facet);
      begins_.push_back({static_cast<std::uint32_t>(passages_.size()), static_cast<std::uint32_t>(edges_.size()),
                         static_cast<std::uint32_t>(coplanar_.size())});
      coplanar_.insert(coplanar_.end(), of_facet.coplanar.begin(), of_facet.coplanar.end());
      passages_.insert(passages_.end(), of_facet.passages.begin(), of_facet.passages.end());
      FacetFrame frame(occluders, of_facet.facet);
      frame.turn_to_front();
      for (const std::uint32_t e : of_facet.lying) {
        edges_.push_back({e, static_cast<std::uint32_t>(sides_.size())});
        for (const FacetAtEdge& use : edges.facets_at(e))
          sides_.push_back(side_of(occluders, frame, edges.edges()[e], use.facet));
      }
    }
}

std::span<const std::uint32_t> Contacts::among(std::uint32_t first, std::uint32_t last) const {
  const auto from = std::lower_bound(facets_.begin(), facets_.end(), first);
  return {from, std::lower_bound(from, facets_.end(), last)};
}

Contacts::Of Contacts::of(std::uint32_t facet) const {
  const std::uint32_t k = place_[facet];
  const Begin& begin = begins_[k];
  const std::size_t passages_end = k + 1 < begins_.size() ? begins_[k + 1].passages : passages_.size();
  const std::size_t edges_end = k + 1 < begins_.size() ? begins_[k + 1].edges : edges_.size();
  const std::size_t coplanar_end = k + 1 < begins_.size() ? begins_[k + 1].coplanar : coplanar_.size();
  return {std::span(passages_).subspan(begin.passages, passages_end - begin.passages),
          std::span(edges_).subspan(begin.edges, edges_end - begin.edges),
          std::span(coplanar_).subspan(begin.coplanar, coplanar_end - begin.coplanar)};
}

}  // namespace lrcs
