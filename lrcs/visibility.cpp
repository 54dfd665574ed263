#include "lrcs/visibility.h"

#include <algorithm>
#include <optional>

#include "lrcs/facet_rise.h"
#include "lrcs/facet_view.h"
#include "lrcs/layer_walk.h"
#include "lrcs/never_faced.h"
#include "lrcs/seen_parts.h"
#include "lrcs/surface.h"

namespace lrcs {

namespace {

// What is seen may be off by so many times the area that outlines sweep as they bend: measured up to a fifth of it on a
// torus in its own shadow, a hundredth for a ball before a plate (docs/methods.md, section 8).
constexpr double bend_doubt = 1.0;

}  // namespace

struct Visibility::Scratch {
  explicit Scratch(const Surface& surface_) : surface(surface_), walks{LayerWalk(surface_), LayerWalk(surface_)} {}

  const Surface& surface;
  std::array<LayerWalk, 2> walks;  // one a viewer
  std::vector<std::uint8_t> wanted;
  std::vector<LayerEdge> edges;
  BentOutlines bent;
  LayerCount count;
  std::optional<FacetView> clipping;
  std::vector<Vec3> viewers;
  bool clipping_looks = false;

  SeenParts* parts = nullptr;  // to be noted, or not

  void look_along(const Vec3& to_transmitter, const Vec3& to_receiver);
  void find_wanted();
  [[nodiscard]] std::optional<Estimate> from_walks(std::uint32_t facet);
  [[nodiscard]] bool is_curved() const { return !surface.occluders.corner_normals.empty(); }
  // Does the surface turn on a facet? domain: is_curved().
  [[nodiscard]] bool turns(std::uint32_t facet) const {
    const auto& normals = surface.occluders.corner_normals[facet];
    return normals[0] != normals[1] || normals[0] != normals[2];
  }
  [[nodiscard]] double error_by_doubtful(std::uint32_t facet) const;
  [[nodiscard]] Estimate clipped(std::uint32_t facet);
};

void Visibility::Scratch::look_along(const Vec3& to_transmitter, const Vec3& to_receiver) {
  viewers.assign(1, to_receiver);
  if (to_transmitter != to_receiver) viewers.push_back(to_transmitter);
  clipping_looks = false;
  for (std::size_t k = 0; k < viewers.size(); ++k) walks[k].look_along(viewers[k]);
  find_wanted();
  for (std::size_t k = 0; k < viewers.size(); ++k) walks[k].count(wanted);
}

// Facets that all viewers see from the same side, unless it is the back of a solid.
void Visibility::Scratch::find_wanted() {
  const std::size_t facets = surface.occluders.size();
  wanted.resize(facets);
  const std::int8_t* const one = walks[0].view().counted();
  const std::int8_t* const other = walks[viewers.size() - 1].view().counted();
  for (std::size_t f = 0; f < facets; ++f) wanted[f] = one[f] != 0 && one[f] == other[f] ? 1 : 0;
}

// Of u and v: facets left out because they are nearly edge-on may hide a strip as wide as rounding.
double Visibility::Scratch::error_by_doubtful(std::uint32_t facet) const {
  double error = 0.0;
  for (std::size_t k = 0; k < viewers.size(); ++k) {
    if (!walks[k].view().is_doubtful()) continue;
    FacetFrame frame(surface.occluders, facet);
    frame.turn(viewers[k]);
    error = std::max(error, frame.rounding(surface.tree.reach()));
  }
  return error;
}

std::optional<Estimate> Visibility::Scratch::from_walks(std::uint32_t facet) {
  edges.clear();
  int base = 0;
  double error = 0.0;
  bool hidden = false;
  for (std::size_t k = 0; k < viewers.size(); ++k) {
    const auto known = walks[k].known(facet);
    if (known == LayerWalk::Known::nothing) return std::nullopt;
    if (known == LayerWalk::Known::layers) {
      hidden = hidden || walks[k].layers_before(facet) > 0;
      continue;
    }
    const auto over = walks[k].outlines_over(facet);
    base += over.base;
    error = std::max(error, over.error);
    edges.insert(edges.end(), over.edges.begin(), over.edges.end());
  }
  const double left_out = error_by_doubtful(facet);
  if (hidden || error == 0.0) return Estimate{hidden ? 0.0 : 1.0, std::min(1.0, 16.0 * left_out)};
  error = std::max(error, left_out);
  if (error >= LayerWalk::hardly_known) return std::nullopt;
  const bool is_noted = parts != nullptr && is_curved() && turns(facet);
  const auto counted = [&](std::span<const LayerEdge> over) {
    return is_noted ? count.uncovered(over, error, base) : AreaMoments{count.uncovered_area(over, error, base)};
  };
  const AreaMoments straight = counted(edges);
  if (count.went_negative()) return std::nullopt;
  AreaMoments seen = straight;
  double bound = std::min(1.0, 4.0 * error * static_cast<double>(edges.size() + 4));
  if (is_curved()) {
    bent.bend(edges, error);
    const auto add_change = [&](AreaMoments moved) {
      moved -= straight;
      seen += moved;
    };
    if (!bent.along_u().empty()) add_change(counted(bent.along_u()));
    if (!bent.along_v().empty()) add_change(counted(bent.along_v()).swapped());
    bound += bend_doubt * 2.0 * bent.swept();
    if (is_noted && seen.area > 0.0 && seen.area < FacetPiece().area())
      parts->add({surface.occluders.original[facet], surface.occluders.first_corner[facet], seen, error, base}, edges,
                 bent);
  }
  return Estimate{std::clamp(2.0 * seen.area, 0.0, 1.0), std::min(1.0, bound)};
}

Estimate Visibility::Scratch::clipped(std::uint32_t facet) {
  if (!clipping) clipping.emplace(surface.occluders, surface.tree);
  if (!clipping_looks) clipping->look_along(viewers);
  clipping_looks = true;
  Estimate seen = clipping->seen_fraction(facet);
  if (is_curved() && seen.value > 0.0 && seen.value < 1.0) {
    // Clipped against flat facets: off by what the surface rises along the facet's sides.
    const FacetRise rise(surface.occluders, facet);
    const auto& e = surface.occluders;
    double most = 0.0, reach = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      most = std::max(most, rise.sagittas[k].norm());
      reach = std::max(reach, (e.positions[e.facets[facet][(k + 1) % 3]] - e.positions[e.facets[facet][k]]).norm());
    }
    seen.bound = std::min(1.0, seen.bound + 8.0 * most * reach / e.cross[facet].norm());
  }
  return seen;
}

Visibility::Visibility(const FacetMesh& mesh) : facets_(mesh.size()), surface_(std::make_unique<const Surface>(mesh)) {}

Visibility::~Visibility() = default;

std::size_t Visibility::look_only_from(std::span<const Vec3> viewers) {
  // Outlines of curved surfaces bend as the facets on both sides tell.
  if (!surface_->occluders.corner_normals.empty()) return 0;
  const auto faced = facets_ever_faced(*surface_, viewers);
  const auto never = static_cast<std::size_t>(std::ranges::count(faced, 0));
  // What is left is prepared anew: as long as 15 directions take, of which each is spared a tenth to a fifth.
  constexpr std::size_t directions_to_prepare = 128;
  if (never * viewers.size() < directions_to_prepare * faced.size()) return 0;
  scratch_.clear();
  surface_ = std::make_unique<const Surface>(*surface_, faced);
  return never;
}

std::size_t Visibility::hull_facets() const {
  return surface_->hull.size();
}

std::vector<Estimate> Visibility::seen_fraction(const Vec3& to_transmitter, const Vec3& to_receiver,
                                                VisibilityCost* cost) const {
  std::vector<Estimate> fraction;
  seen_fraction(to_transmitter, to_receiver, fraction, cost);
  return fraction;
}

void Visibility::seen_fraction(const Vec3& to_transmitter, const Vec3& to_receiver, std::vector<Estimate>& fraction,
                               VisibilityCost* cost, SeenParts* parts) const {
  std::unique_ptr<Scratch>& scratch = scratch_.local();
  if (!scratch) scratch = std::make_unique<Scratch>(*surface_);
  scratch->look_along(to_transmitter, to_receiver);
  VisibilityCost spent;
  for (std::size_t k = 0; k < scratch->viewers.size(); ++k) {
    spent.cut += scratch->walks[k].cut_facets();
    spent.hidden += scratch->walks[k].hidden_facets();
    spent.queries += scratch->walks[k].queries();
    spent.free_convex_parts += scratch->walks[k].free_parts().free_convex_parts();
    spent.other_free_parts += scratch->walks[k].free_parts().other_free_parts();
  }
  scratch->parts = parts;
  if (parts != nullptr) parts->clear();
  fraction.assign(facets_, {});
  const auto& occluders = surface_->occluders;
  for (std::uint32_t f = 0; f < occluders.size(); ++f) {
    Estimate& of_facet = fraction[occluders.original[f]];
    if (scratch->wanted[f] == 0) {
      // Edge-on as far as rounding can tell, for one viewer at least.
      for (std::size_t k = 0; k < scratch->viewers.size(); ++k)
        if (scratch->walks[k].view().facing()[f] == 0) of_facet = scratch->clipped(f);
      continue;
    }
    if (const auto known = scratch->from_walks(f)) {
      of_facet = *known;
    } else {
      of_facet = scratch->clipped(f);
      ++spent.clipped;
    }
  }
  if (cost != nullptr) *cost = spent;
}

std::vector<Estimate> Visibility::seen_fraction_by_clipping(const Vec3& to_transmitter, const Vec3& to_receiver) const {
  FacetView view(surface_->occluders, surface_->tree);
  view.look_along(to_transmitter == to_receiver ? std::vector{to_receiver} : std::vector{to_transmitter, to_receiver});
  std::vector<Estimate> fraction(facets_);
  for (std::uint32_t f = 0; f < surface_->occluders.size(); ++f)
    fraction[surface_->occluders.original[f]] = view.seen_fraction(f);
  return fraction;
}

std::vector<std::array<std::uint32_t, 2>> Visibility::coincident_facets() const {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const auto& original = surface_->occluders.original;
  for (std::uint32_t f = 0; f < surface_->occluders.size(); ++f) {
    if (!surface_->contacts.any(f)) continue;
    for (const std::uint32_t other : surface_->contacts.of(f).coplanar) pairs.push_back({original[f], original[other]});
  }
  return pairs;
}

}  // namespace lrcs
