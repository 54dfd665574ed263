#include "lrcs/curved_returns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include "lrcs/return_error.h"

namespace lrcs {
namespace {

using Facet = CurvedSurface::Facet;

// A place on a facet, and how its surface faces the two directions there.
struct Corner {
  std::array<double, 3> at;
  double facing_i, facing_r;  // cosines times area, of the side looked at
};

// At most a triangle cut by two lines, each bent once.
struct Polygon {
  std::array<Corner, 9> corners;
  std::size_t size = 0;

  void add(const Corner& corner) { corners[size++] = corner; }
};

Corner between(const Corner& a, const Corner& b, double share) {
  Corner c{};
  for (std::size_t k = 0; k < 3; ++k) c.at[k] = a.at[k] + share * (b.at[k] - a.at[k]);
  c.facing_i = a.facing_i + share * (b.facing_i - a.facing_i);
  c.facing_r = a.facing_r + share * (b.facing_r - a.facing_r);
  return c;
}

// The surface of one facet, and how it faces the directions at any place.
struct Sight {
  const CurvedPatch& patch;
  Vec3 wi, wr;  // of the side looked at

  [[nodiscard]] Corner at(const std::array<double, 3>& place) const {
    const Vec3 vector = area_vector_at(patch, place);
    return {place, vector.dot(wi), vector.dot(wr)};
  }

  // Where the surface turns away between two places: a line, and a parabola through three of its places.
  [[nodiscard]] Corner turn(const Corner& a, const Corner& b, double Corner::*facing) const {
    const double from = a.*facing, to = b.*facing;
    const Corner first = at(between(a, b, from / (from - to)).at);
    const bool is_beyond = (first.*facing > 0.0) == (from > 0.0);
    const double near = first.*facing, other = is_beyond ? to : from;
    if (near == 0.0 || !(near / (near - other) <= 1.0)) return first;
    return at(between(first, is_beyond ? b : a, near / (near - other)).at);
  }

  // Half way along the line from where a polygon's rim leaves what faces the direction to where it comes back, moved
  // so far that the two pieces have the area of the parabola over it.
  [[nodiscard]] Corner bend(const Corner& leaves, const Corner& enters, double Corner::*facing) const {
    const Corner middle = at(between(leaves, enters, 0.5).at);
    // Across the line on the facet; how facing changes there is taken from a step as long as a quarter of it.
    const std::array<double, 3> along{enters.at[0] - leaves.at[0], enters.at[1] - leaves.at[1],
                                      enters.at[2] - leaves.at[2]};
    Corner aside = middle;
    for (std::size_t k = 0; k < 3; ++k)
      aside.at[k] += 0.25 / std::sqrt(3.0) * (along[(k + 1) % 3] - along[(k + 2) % 3]);
    aside = at(aside.at);
    const double change = aside.*facing - middle.*facing;
    constexpr double of_area = 4.0 / 3.0;  // two thirds of the parabola's height against half of the triangle's
    const double step = -of_area * middle.*facing / change;
    if (!(std::abs(step) <= 1.0)) return middle;
    return at(between(middle, aside, step).at);
  }

  // What of a polygon faces a direction.
  [[nodiscard]] Polygon cut(const Polygon& polygon, double Corner::*facing) const {
    Polygon rest;
    for (std::size_t k = 0; k < polygon.size; ++k) {
      const Corner &a = polygon.corners[k], &b = polygon.corners[(k + 1) % polygon.size];
      if (a.*facing > 0.0) {
        rest.add(a);
        if (b.*facing > 0.0) continue;
        const Corner leaves = turn(a, b, facing);
        rest.add(leaves);
        if (const auto enters = entry(polygon, k + 1, facing)) rest.add(bend(leaves, *enters, facing));
      } else if (b.*facing > 0.0) {
        rest.add(turn(a, b, facing));
      }
      if (rest.size + 3 > rest.corners.size()) break;
    }
    return rest;
  }

 private:
  // Where the rim comes back, from corner `from` on.
  [[nodiscard]] std::optional<Corner> entry(const Polygon& polygon, std::size_t from, double Corner::*facing) const {
    for (std::size_t k = 0; k < polygon.size; ++k) {
      const Corner& a = polygon.corners[(from + k) % polygon.size];
      const Corner& b = polygon.corners[(from + k + 1) % polygon.size];
      if (a.*facing <= 0.0 && b.*facing > 0.0) return turn(a, b, facing);
    }
    return std::nullopt;
  }
};

// Quarters of a facet: the places of their corners, and which.
constexpr std::array<std::array<double, 3>, 6> halfway{
    {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {0.5, 0.5, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}}};
constexpr std::array<std::array<std::size_t, 3>, 4> quarters{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};

class Looking {
 public:
  Looking(const Target& target, std::span<const Estimate> seen, std::span<const SeenMiddle> middles, const Vec3& wi,
          const Vec3& wr)
      : target_(target), seen_(seen), wi_(wi), wr_(wr), retro_(wi == wr), tilts_(target.curved.facets().size()) {
    constexpr double variance = 1.0 / 12.0;  // of places on a triangle, by weights whose sum is 1
    for (const SeenMiddle& middle : middles) {
      const std::uint32_t place = target.curved.place_of(middle.facet);
      if (place == CurvedSurface::none) continue;
      Tilt& tilt = tilts_[place];
      for (std::size_t c = 0; c < 3; ++c) tilt[c] = (middle.at[c] - 1.0 / 3.0) / variance;
      // No place counts less than nothing.
      double least = 0.0;
      for (const auto& at : patch_rule().at)
        least = std::min(least, tilt[0] * at[0] + tilt[1] * at[1] + tilt[2] * at[2]);
      if (least < -1.0)
        for (double& t : tilt) t /= -least;
    }
  }

  // Of its sides of one material.
  template <class Model, class Pair>
  CurvedReturn at(const Facet& facet, std::uint32_t material, const Model& model_seen, const Pair& pair_seen,
                  const Model& unseen, const Pair& pair_unseen) const {
    CurvedReturn sum;
    // Rounding does not matter: what is cut where it need not be is cut at its rim.
    const Range of_i = facing(facet, wi_), of_r = facing(facet, wr_);
    const bool whole = of_i.least * of_i.most > 0.0 && of_r.least * of_r.most > 0.0;
    for (const double side : {1.0, -1.0}) {
      if (side < 0.0 && target_.sides == Sides::front) continue;
      if ((side > 0.0 ? target_.material : target_.back_material())[facet.facet] != material) continue;
      if (!may_face(facet, side)) continue;
      const Estimate fraction = fraction_of(facet, side);
      if (fraction.value == 0.0 && fraction.bound == 0.0) continue;
      const Model& model = fraction.value > 0.0 ? model_seen : unseen;
      const Pair& pair = fraction.value > 0.0 ? pair_seen : pair_unseen;
      CurvedReturn here;
      if (whole || facet.folded || facet.planar)
        add_whole(facet, side, model, pair, here);
      else
        add_cut(facet, side, model, pair, here);
      sum.returned += fraction.value * here.returned;
      sum.lower += fraction.value * here.lower;
      sum.bound += fraction.bound * std::abs(here.returned) + fraction.value * here.bound;
      sum.lit_seen += fraction.value * here.lit_seen;
      sum.seen_area += fraction.value * here.seen_area;
    }
    return sum;
  }

 private:
  // How much more of a facet is seen toward its corners than in its middle: what is seen counts as the facet with a
  // density 1 + tilt . (weights of the corners), which has the same middle. Exact for what varies linearly.
  using Tilt = std::array<double, 3>;

  [[nodiscard]] Tilt tilt_of(const Facet& facet, double side) const {
    return faces(facet.facet, side) ? tilts_[target_.curved.place_of(facet.facet)] : Tilt{};
  }

  struct Range {
    double least, most;
  };

  // The cosines that a direction has on a facet, as far as their signs go.
  static Range facing(const Facet& facet, const Vec3& w) {
    const double middle = facet.axis.dot(w);
    if (std::abs(middle) > facet.spread || facet.planar) return {middle, middle};
    Range range{middle, middle};
    for (const Vec3& normal : facet.patch.normal) {
      const double there = middle + CurvedSurface::beyond_places * (normal.dot(w) - middle);
      range.least = std::min(range.least, there);
      range.most = std::max(range.most, there);
    }
    return range;
  }
  static double least(const Range& range, double side) { return side > 0.0 ? range.least : -range.most; }

  [[nodiscard]] bool faces(std::size_t facet, double side) const {
    const Vec3& n = target_.mesh.normals[facet];
    return side * n.dot(wi_) > 0.0 && side * n.dot(wr_) > 0.0;
  }

  // Of a side of a facet. Near to where the surface turns away, flat facets stand in each other's light as the surface
  // does not: there, that of the nearest facets clear of it, if they are seen whole and the flat facet mostly is, or is
  // turned away itself. What the two differ by is not known better.
  [[nodiscard]] Estimate fraction_of(const Facet& facet, double side) const {
    const Estimate own = faces(facet.facet, side) ? seen_[facet.facet] : Estimate{};
    if (is_clear(facet, side)) return own;
    const auto beside = fraction_beside(facet, side);
    if (!beside) return own;
    if (!faces(facet.facet, side)) return *beside;
    const double apart = std::abs(beside->value - own.value);
    const double value = beside->value == 1.0 && own.value > 0.5 ? 1.0 : own.value;
    return {value, std::max(own.bound, apart)};
  }

  // The mean of the nearest facets that are clear of where the surface turns away, on the way over those that are not.
  [[nodiscard]] std::optional<Estimate> fraction_beside(const Facet& facet, double side) const {
    constexpr std::size_t most_rings = 8;
    std::vector<std::uint32_t> met{facet.facet};
    std::size_t first = 0;
    for (std::size_t ring = 0; ring < most_rings; ++ring) {
      Estimate sum;
      double count = 0.0;
      for (const std::size_t last = met.size(); first < last; ++first)
        for (const std::uint32_t k : curved(met[first]).adjacent) {
          if (k == CurvedSurface::none || std::find(met.begin(), met.end(), k) != met.end()) continue;
          if (!is_clear(curved(k), side)) {
            if (may_face(curved(k), side)) met.push_back(k);
            continue;
          }
          sum.value += seen_[k].value;
          sum.bound += seen_[k].bound;
          count += 1.0;
        }
      if (count > 0.0) return Estimate{sum.value / count, sum.bound / count};
    }
    return std::nullopt;
  }

  [[nodiscard]] const Facet& curved(std::uint32_t facet) const {
    return target_.curved.facets()[target_.curved.place_of(facet)];
  }

  [[nodiscard]] bool is_clear(const Facet& facet, double side) const {
    return faces(facet.facet, side) && least(facing(facet, wi_), side) > 0.0 && least(facing(facet, wr_), side) > 0.0;
  }

  // Whether some of a facet's surface may face both directions.
  [[nodiscard]] bool may_face(const Facet& facet, double side) const {
    return least(facing(facet, wi_), -side) < 0.0 && least(facing(facet, wr_), -side) < 0.0;
  }

  // Where the rules of two degrees differ by more than this of the most that the facet could return, there is a lobe or
  // a crease of the model within it: it is looked at in quarters.
  template <class Model, class Pair>
  void add_whole(const Facet& facet, double side, const Model& model, const Pair& pair, CurvedReturn& sum) const {
    constexpr double rough = 1e-5;
    constexpr int most_depth = 3;
    CurvedReturn whole;
    const Tilt tilt = tilt_of(facet, side);
    add(facet.patch, facet.planar, side, model, pair, whole, tilt);
    const double most = rough * model.largest();
    if (facet.folded || tilt != Tilt{} || std::abs(whole.returned - whole.lower) <= most * facet.area) {
      sum += whole;
      return;
    }
    add_quarters(facet, {halfway[0], halfway[1], halfway[2]}, most, most_depth, side, model, pair, sum);
  }

  template <class Model, class Pair>
  void add_quarters(const Facet& facet, const std::array<std::array<double, 3>, 3>& corners, double most, int depth,
                    double side, const Model& model, const Pair& pair, CurvedReturn& sum) const {
    for (const auto& quarter : quarters) {
      std::array<std::array<double, 3>, 3> part{};
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t c = 0; c < 3; ++c)
          for (std::size_t j = 0; j < 3; ++j) part[k][c] += halfway[quarter[k]][j] * corners[j][c];
      CurvedReturn here;
      const CurvedPatch patch = part_of(facet.patch, part);
      add(patch, false, side, model, pair, here, {});
      if (depth > 1 && std::abs(here.returned - here.lower) > most * patch.area[0])
        add_quarters(facet, part, most, depth - 1, side, model, pair, sum);
      else
        sum += here;
      // Beside a crease rules of both degrees may err alike, facet after facet.
      sum.bound += depth > 1 ? 0.0 : std::abs(here.returned - here.lower);
    }
  }

  template <class Model, class Pair>
  void add(const CurvedPatch& patch, bool planar, double side, const Model& model, const Pair& pair, CurvedReturn& sum,
           const Tilt& tilt) const {
    const std::size_t places = planar ? 1 : PatchRule::size;
    for (std::size_t k = 0; k < places; ++k) {
      const Vec3 n = side * patch.normal[k];
      const double cos_i = n.dot(wi_), cos_r = n.dot(wr_), least = std::min(cos_i, cos_r);
      if (!(least > 0.0)) continue;
      const auto& at = patch_rule().at[k];
      const double share = 1.0 + tilt[0] * at[0] + tilt[1] * at[1] + tilt[2] * at[2];
      const double weight = planar ? 1.0 : share * patch_rule().weight[k];
      const double lower = planar ? 1.0 : share * patch_rule().lower[k];
      const double value = patch.area[k] * (retro_ ? model.f_cos_cos_retro(std::min(cos_i, 1.0)) : pair(n));
      sum.returned += weight * value;
      sum.lower += lower * value;
      sum.lit_seen += weight * patch.area[k];
      sum.seen_area += weight * patch.area[k] * cos_r;
      sum.bound += std::abs(weight * value) * (least > model_error ? model_error / least : 1.0) +
                   (value != 0.0 ? std::abs(weight * patch.area[k]) * lobe_error(pair, n) : 0.0);
    }
  }

  // Of a facet that is turned away in part. Quarters: where it turns lies on a parabola, nearly.
  template <class Model, class Pair>
  void add_cut(const Facet& facet, double side, const Model& model, const Pair& pair, CurvedReturn& sum) const {
    const Sight sight{facet.patch, side * wi_, side * wr_};
    std::array<Corner, 6> corners{};
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = sight.at(halfway[k]);
    for (const auto& quarter : quarters) {
      Polygon polygon;
      for (const std::size_t corner : quarter) polygon.add(corners[corner]);
      polygon = sight.cut(polygon, &Corner::facing_i);
      if (!retro_) polygon = sight.cut(polygon, &Corner::facing_r);
      for (std::size_t k = 2; k < polygon.size; ++k)
        add(part_of(facet.patch, {polygon.corners[0].at, polygon.corners[k - 1].at, polygon.corners[k].at}), false,
            side, model, pair, sum, {});
    }
    // The line is interpolated: off by a part of the facet of second order in how far the facet turns.
    sum.bound += facet.spread * facet.spread * std::abs(sum.returned);
  }

  const Target& target_;
  std::span<const Estimate> seen_;
  const Vec3 &wi_, &wr_;
  bool retro_;
  std::vector<Tilt> tilts_;  // one a curved facet
};

}  // namespace

std::vector<CurvedReturn> curved_returns(const Target& target, std::span<const Estimate> seen,
                                         std::span<const SeenMiddle> middles, const Vec3& to_transmitter,
                                         const Vec3& to_receiver) {
  const auto& facets = target.curved.facets();
  std::vector<CurvedReturn> returns(facets.size());
  if (facets.empty()) return returns;
  const Looking looking(target, seen, middles, to_transmitter, to_receiver);
  const auto& behind = target.back_material();
  for (std::uint32_t m = 0; m < target.materials.size(); ++m)
    std::visit(
        [&](const auto& model) {
          const auto pair = model.for_pair(to_transmitter, to_receiver);
          // Never asks for what was not measured: of facets that only rounding may make visible, and of what is black.
          const auto& unseen = supposed(model);
          const auto pair_unseen = unseen.for_pair(to_transmitter, to_receiver);
          const bool black = returns_nothing(target.materials[m]);
          for (std::size_t k = 0; k < facets.size(); ++k)
            if (const std::uint32_t f = facets[k].facet; target.material[f] == m || behind[f] == m)
              returns[k] += black ? looking.at(facets[k], m, unseen, pair_unseen, unseen, pair_unseen)
                                  : looking.at(facets[k], m, model, pair, unseen, pair_unseen);
        },
        target.materials[m].brdf);
  return returns;
}

}  // namespace lrcs
