#include "lrcs/hull_facets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "lrcs/plane_side.h"
#include "lrcs/support_tree.h"

namespace lrcs {
namespace {

// Facets looked at one after another, by one thread. What is spent on one is not there for the others: of the same
// facets the same is told whatever the number of threads.
constexpr std::uint32_t run = 1024;

// About ten nanoseconds each.
std::int64_t steps_a_run(std::uint32_t facets) {
  constexpr std::uint32_t in_all = 1U << 24U, least = 64, most = 1024;
  return std::int64_t{run} * std::clamp(in_all / std::max(facets, 1U), least, most);
}

// Looks at all runs with half of the steps that there are. Those of which that is not enough share what is left: hulls
// mostly touch a target in a few places. `look_at_run`: of a run and its steps, returns what it has left of them.
template <class LookAtRun>
void share_steps(std::uint32_t runs, std::int64_t steps, const LookAtRun& look_at_run) {
  std::vector<std::int64_t> left(runs);
  tbb::parallel_for(std::uint32_t{0}, runs,
                    [&](std::uint32_t k) { left[k] = look_at_run(k, static_cast<int>(steps / 2)); });
  std::vector<std::uint32_t> stuck;
  for (std::uint32_t k = 0; k < runs; ++k)
    if (left[k] == 0) stuck.push_back(k);
  if (stuck.empty()) return;
  constexpr std::int64_t most = std::int64_t{4096} * run;
  const std::int64_t spare = std::accumulate(left.begin(), left.end(), runs * (steps / 2));
  const auto share = static_cast<int>(std::min(most, spare / static_cast<std::int64_t>(stuck.size())));
  tbb::parallel_for(std::size_t{0}, stuck.size(), [&](std::size_t k) { look_at_run(stuck[k], share); });
}

constexpr std::uint32_t any_part = 0xffffffff;

std::vector<Vec3> vertex_normals(const Occluders& occluders) {
  std::vector<Vec3> normals(occluders.positions.size(), Vec3::Zero());
  for (std::size_t f = 0; f < occluders.size(); ++f)
    for (const std::uint32_t v : occluders.facets[f]) normals[v] += occluders.cross[f];
  return normals;
}

class HullSearch {
 public:
  HullSearch(const Occluders& occluders, const OccluderEdges& edges, const SurfaceParts& parts)
      : occluders_(occluders),
        edges_(edges),
        parts_(parts),
        normals_(vertex_normals(occluders)),
        all_(occluders.positions.size()),
        of_part_(parts.size()) {
    std::iota(all_.begin(), all_.end(), 0U);
    tbb::parallel_for(std::uint32_t{0}, parts.size(),
                      [&](std::uint32_t part) { of_part_[part].emplace(occluders, normals_, parts.vertices(part)); });
    if (parts.size() > 1) of_all_.emplace(occluders, normals_, all_);
  }

  // From facet to facet: a vertex in front of one is often in front of the next one too.
  struct Walk {
    struct Witness {
      std::uint32_t part = any_part;
      std::uint32_t vertex = SupportTree::nothing;
    };
    int effort;  // steps left
    Witness of_all, of_part;
  };

  [[nodiscard]] bool nothing_of_its_part_before(std::uint32_t facet, bool from_behind, Walk& walk) const {
    const std::uint32_t part = parts_.of(facet);
    if (!from_behind && parts_.is_convex(part)) return true;
    const SupportTree::Plane plane(occluders_, facet, from_behind);
    return !has_neighbour_in_front(facet, plane) &&
           nothing_in_front(*of_part_[part], plane, part, walk.of_part, walk.effort);
  }
  // domain: nothing_of_its_part_before() has said yes.
  [[nodiscard]] bool nothing_before(std::uint32_t facet, bool from_behind, Walk& walk) const {
    const SupportTree::Plane plane(occluders_, facet, from_behind);
    return !of_all_ || nothing_in_front(*of_all_, plane, any_part, walk.of_all, walk.effort);
  }

 private:
  // Across an edge that bends toward the front is a corner there: that settles most facets.
  [[nodiscard]] bool has_neighbour_in_front(std::uint32_t facet, const SupportTree::Plane& plane) const {
    const auto& at = occluders_.positions;
    for (const std::uint32_t across : edges_.across(facet)) {
      if (across == OccluderEdges::alone) continue;
      for (const std::uint32_t v : occluders_.facets[across / 2])
        if (certain_plane_side(at[plane.corners[0]], plane.cross, at[v]) == 1) return true;
    }
    return false;
  }
  [[nodiscard]] bool nothing_in_front(const SupportTree& tree, const SupportTree::Plane& plane, std::uint32_t part,
                                      Walk::Witness& witness, int& effort) const {
    const auto& at = occluders_.positions;
    if (witness.vertex != SupportTree::nothing && witness.part == part &&
        certain_plane_side(at[plane.corners[0]], plane.cross, at[witness.vertex]) == 1)
      return false;
    constexpr int most = 1 << 13;
    const int before = std::min(most, effort);
    int left = before;
    const std::uint32_t found = tree.in_front(plane, left);
    effort -= before - std::max(left, 0);
    if (found < SupportTree::unknown) witness = {part, found};
    return found == SupportTree::nothing;
  }

  const Occluders& occluders_;
  const OccluderEdges& edges_;
  const SurfaceParts& parts_;
  std::vector<Vec3> normals_;
  std::vector<std::uint32_t> all_;
  std::vector<std::optional<SupportTree>> of_part_;
  std::optional<SupportTree> of_all_;
};

}  // namespace

HullFacets::HullFacets(const Occluders& occluders, const OccluderEdges& edges, const Contacts& contacts,
                       const std::vector<std::uint8_t>& of_solid, const SurfaceParts& parts)
    : sides_(occluders.size(), 0) {
  const HullSearch search(occluders, edges, parts);
  const auto look = [&](std::uint32_t f, bool from_behind, HullSearch::Walk& walk) -> unsigned {
    if (!search.nothing_of_its_part_before(f, from_behind, walk)) return 0;
    const unsigned in_part = from_behind ? back_in_part : front_in_part, in_target = from_behind ? back : front;
    return search.nothing_before(f, from_behind, walk) ? in_part | in_target : in_part;
  };
  const auto facets = static_cast<std::uint32_t>(occluders.size());
  share_steps((facets + run - 1) / run, steps_a_run(facets), [&](std::uint32_t k, int steps) {
    HullSearch::Walk walk{steps, {}, {}};
    for (std::uint32_t f = k * run; f < std::min(facets, (k + 1) * run); ++f) {
      if (contacts.any(f)) continue;
      const unsigned seen_from_behind = of_solid[f] != 0 ? 0U : look(f, true, walk);
      sides_[f] = static_cast<std::uint8_t>(look(f, false, walk) | seen_from_behind);
    }
    return walk.effort;
  });
  count();
}

HullFacets::HullFacets(const HullFacets& whole, const std::vector<std::uint8_t>& kept) {
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (kept[f] != 0) sides_.push_back(whole.sides_[f]);
  count();
}

void HullFacets::count() {
  for (const std::uint8_t sides : sides_) size_ += (sides & (front | back)) != 0 ? 1 : 0;
}

}  // namespace lrcs
