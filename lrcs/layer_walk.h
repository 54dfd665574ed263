#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lrcs/cover_grid.h"
#include "lrcs/edge_grid.h"
#include "lrcs/edge_sieve.h"
#include "lrcs/facet_cut.h"
#include "lrcs/facet_sight.h"
#include "lrcs/free_parts.h"
#include "lrcs/layer_query.h"
#include "lrcs/surface.h"
#include "lrcs/view_outline.h"

namespace lrcs {

// How many layers stand before every facet, toward one viewer: counted by walking over the surface.
// Most facets meet no outline: the count is one number there, the same as next door. A few are cut by outlines; there
// it changes by what each outline gains. One true count starts the walk over each connected patch; the rest is steps
// from facet to facet through ordinary edges.
// laws: agrees along every way round, and at the far end of a long way; is never negative. Facets for which it does not
// are said to be unknown.
// One object a thread. source: A. Appel, Proc. 22nd ACM National Conf., 387-393, 1967 (quantitative invisibility).
class LayerWalk {
 public:
  explicit LayerWalk(const Surface& surface) : surface_(surface), view_(surface), free_(surface) {}

  void look_along(const Vec3& toward) { view_.look_along(toward); }
  [[nodiscard]] const ViewOutline& view() const { return view_; }
  [[nodiscard]] const FreeParts& free_parts() const { return free_; }

  // Counts the layers before the facets that are wanted. shape: one a facet. domain: those wanted face the viewer with
  // one side or the other.
  void count(const std::vector<std::uint8_t>& wanted);

  enum class Known { nothing, layers, outlines };
  // layers: layers_before(facet), everywhere on it. outlines: outlines_over(facet) tells.
  [[nodiscard]] Known known(std::uint32_t facet) const {
    const State& state = states_[facet];
    return state.layers <= failed ? Known::nothing : state.cut == none ? Known::layers : Known::outlines;
  }
  [[nodiscard]] int layers_before(std::uint32_t facet) const { return states_[facet].layers; }
  struct Outlines {
    int base;  // layers at u = -infinity
    std::span<const LayerEdge> edges;
    double error;
  };
  [[nodiscard]] Outlines outlines_over(std::uint32_t facet) const;
  // With larger errors there is nothing to walk by.
  static constexpr double hardly_known = 0x1p-20;

  // Facets cut, facets told to be hidden by a coarse look, and true counts taken, for the last direction.
  [[nodiscard]] std::size_t cut_facets() const { return cuts_.size(); }
  [[nodiscard]] std::size_t hidden_facets() const { return hidden_; }
  [[nodiscard]] std::size_t queries() const { return queries_; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr int unknown = -0x40000000;
  static constexpr int not_wanted = unknown + 1;
  static constexpr int failed = unknown + 2;
  static constexpr int hidden = 0x40000000;  // some layers, wherever one looks: nobody walks there

  struct State {        // of a facet
    int layers;         // before it; the base for one that is cut
    std::uint32_t cut;  // its place in cuts_; none
  };
  struct Cut {
    std::uint32_t facet;
    std::uint32_t first_edge;
    double error;
    std::array<int, 3> at_port;
    std::array<bool, 3> clear;
  };

  void find_cuts();
  // Marks a facet as hidden, if the coarse look tells.
  bool is_covered(std::uint32_t facet);
  // Fills cut_ with all that runs in front of the facet. False: nothing does.
  bool cut(std::uint32_t facet);
  void sift(const SeenFacet& seen, const EdgeGrid::Cells& cells);
  void keep_cut(std::uint32_t facet);
  // Many outlines over a facet are not kept where they leave nothing of it to be seen.
  [[nodiscard]] bool is_hidden_by_many(std::uint32_t facet);
  void keep_hidden(std::uint32_t facet);
  // Told without looking at the view: such facets are neither cut nor queried.
  [[nodiscard]] bool nothing_before(std::uint32_t facet) const {
    return free_.nothing_before(facet, view_.counts(facet));
  }
  [[nodiscard]] bool take_free(const std::vector<std::uint8_t>& wanted);
  // Starts at a facet, unless it is known, and walks from there.
  void begin_walk(std::uint32_t facet);
  // Finds the count on one facet by counting layer by layer.
  bool start(std::uint32_t facet);
  // On a facet that no outline cuts; nothing where no place on it is clear of what is before it.
  [[nodiscard]] std::optional<int> count_layers(std::uint32_t facet);
  [[nodiscard]] bool agrees_at_far_end();
  // Of the facet in cut_: layers at u = -infinity.
  [[nodiscard]] std::optional<int> base_of_cut(std::uint32_t facet);
  // Steps from facet to facet as far as it goes. False: the count differs between two ways, or falls below zero.
  bool walk_from(std::uint32_t facet);
  // Layers before what lies across side k of a facet, less its base; nothing where an outline runs too near.
  [[nodiscard]] std::optional<int> layers_across(std::uint32_t facet, std::size_t side, std::uint32_t other) const;

  const Surface& surface_;
  ViewOutline view_;
  FreeParts free_;
  CoverGrid cover_;
  EdgeGrid grid_;
  EdgeSieve sieve_;
  FacetSight sight_;
  FacetCut cut_;
  LayerCount count_;
  std::vector<std::uint32_t> found_;  // outline edges that the sieve lets through
  std::vector<std::uint32_t> stamp_;  // of outline edges: the last cut that looked at it
  std::uint32_t last_stamp_ = 0;
  std::vector<State> states_;
  std::vector<Cut> cuts_;
  std::vector<LayerEdge> edges_;
  std::vector<std::uint32_t> patch_;  // facets of the walk at hand
  std::size_t hidden_ = 0, queries_ = 0;
};

}  // namespace lrcs
