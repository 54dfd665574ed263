#include "lrcs/curved_returns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "brdf/retro_form.h"
#include "lrcs/return_error.h"
#include "lrcs/rim_cut.h"
#include "lrcs/stand_in.h"
#include "lrcs/surface_fractions.h"

namespace lrcs {
namespace {

using Facet = CurvedSurface::Facet;

// A number for each place of the rule, and one more, not used: vectors hold powers of two.
constexpr std::size_t lanes = PatchRule::size + 1;
using Lanes = std::array<double, lanes>;

// Has a model creases, and does it tell on which sides of them a normal lies?
template <class Pair>
concept HasCreases = requires(const Pair& pair, const Vec3& n) {
  pair.creases(n);
};

// How a material returns to the pair of directions.
template <class Model>
struct Reflection {
  Reflection(const Model& of, const Vec3& wi, const Vec3& wr) : model(of), pair(of.for_pair(wi, wr)) {
    if (wi == wr) retro = retro_form(of);
  }

  // f_r cos_i cos_r [1/sr] at the places of a patch where the lesser of their cosines is above zero.
  void at(const CurvedPatch& patch, double side, bool is_retro, const Lanes& cosines, Lanes& values) const {
    if (retro) {
      for (std::size_t k = 0; k < lanes; ++k) {
        const double cosine = std::min(cosines[k], 1.0);
        values[k] = (*retro)(std::max(cosine, smallest_retro_cosine)) * cosine;
      }
      return;
    }
    for (std::size_t k = 0; k < PatchRule::size; ++k)
      if (cosines[k] > 0.0)
        values[k] = is_retro ? model.f_cos_cos_retro(std::min(cosines[k], 1.0)) : pair(Vec3(side * patch.normal[k]));
  }

  const Model& model;
  decltype(std::declval<const Model&>().for_pair(Vec3(), Vec3())) pair;
  decltype(retro_form(std::declval<const Model&>())) retro{};
};

class Looking {
 public:
  Looking(const Target& target, std::span<const Estimate> seen, SeenParts* parts, const Vec3& wi, const Vec3& wr)
      : target_(target),
        seen_(seen),
        fractions_(target, seen, wi, wr),
        wi_(wi),
        wr_(wr),
        retro_(wi == wr),
        parts_(parts) {
    if (parts == nullptr) return;
    part_of_.resize(target.curved.facets().size());
    for (const SeenParts::Part& part : parts->parts())
      if (const std::uint32_t place = target.curved.place_of(part.facet); place != CurvedSurface::none)
        part_of_[place] = &part;
  }

  // Of its sides of one material.
  template <class Model>
  CurvedReturn at(const Facet& facet, std::uint32_t material, const Reflection<Model>& seen,
                  const Reflection<Model>& unseen) {
    CurvedReturn sum;
    const SurfaceFractions::Facing facing = fractions_.facing_of(facet);
    for (const double side : {1.0, -1.0}) {
      if (side < 0.0 && target_.sides == Sides::front) continue;
      if (!facing.may_be_lit_and_seen(side)) continue;
      if ((side > 0.0 ? target_.material : target_.back_material())[facet.facet] != material) continue;
      const Estimate fraction = fractions_.fraction_of(facet, facing, side);
      if (fraction.value == 0.0 && fraction.bound == 0.0) continue;
      const Reflection<Model>& reflection = fraction.value > 0.0 ? seen : unseen;
      CurvedReturn here;
      // Rounding does not matter: what is cut where it need not be is cut at its rim.
      if (facing.is_whole() || facet.folded || facet.planar)
        add_whole(facet, side, part_of(facet, fraction), reflection, here);
      else
        add_cut(facet, side, reflection, here);
      sum.returned += fraction.value * here.returned;
      sum.lower += fraction.value * here.lower;
      sum.bound += fraction.bound * std::abs(here.returned) + fraction.value * here.bound;
      sum.lit_seen += fraction.value * here.lit_seen;
      sum.seen_area += fraction.value * here.seen_area;
    }
    return sum;
  }

 private:
  // What is seen of a facet that is seen in part; null where that is not known better than by its fraction.
  [[nodiscard]] const SeenParts::Part* part_of(const Facet& facet, const Estimate& fraction) const {
    if (part_of_.empty() || facet.folded || fraction.value != seen_[facet.facet].value) return nullptr;
    return part_of_[target_.curved.place_of(facet.facet)];
  }

  // Where the rules of two degrees differ by more than `rough` of the most that the facet could return, there is a lobe
  // or a crease of the model within it, and where values differ by more than `steep` of that most, the rules may agree
  // by chance: it is looked at in quarters; and they again, unless together they return what the whole does, within
  // `alike` of that most. Pieces that a known crease runs through always are: the places of the rules may all lie on
  // one side of it.
  static constexpr double rough = 1e-5, steep = 0.5, alike = 1e-6;

  template <class Model>
  void add_whole(const Facet& facet, double side, const SeenParts::Part* part, const Reflection<Model>& reflection,
                 CurvedReturn& sum) {
    if (facet.planar) {
      add_planar(facet, side, reflection, sum);
      return;
    }
    constexpr int most_depth = 3;
    std::optional<PatchPolynomial> surface;
    if (part != nullptr) surface.emplace(facet.patch);
    const Look look = part != nullptr ? look_at(seen_patch(*surface, {}, *part, part->seen), side, reflection)
                                      : look_at(facet.patch, side, reflection);
    CurvedReturn here = look.sum;
    if (!facet.folded && is_rough(look, facet, 1.0, reflection)) {
      if (!surface) surface.emplace(facet.patch);
      here = {};
      add_quarters(facet, *surface, {}, part, look.sum.returned, most_depth, side, reflection, here);
    }
    if (part != nullptr) here /= seen_[facet.facet].value;
    sum += here;
  }

  // At a piece of a facet, by its rule.
  struct Look {
    CurvedReturn sum;
    double range = 0.0;  // of f_r cos_i cos_r [1/sr]
    bool is_creased = false;
  };
  template <class Model>
  [[nodiscard]] Look look_at(const CurvedPatch& patch, double side, const Reflection<Model>& reflection) const {
    Look look;
    look.range = add(patch, side, reflection, look.sum);
    look.is_creased = !retro_ && has_crease(reflection.pair, patch, side);
    return look;
  }

  // Of a piece that is such a share of the facet.
  template <class Model>
  [[nodiscard]] static bool is_rough(const Look& look, const Facet& facet, double share,
                                     const Reflection<Model>& reflection) {
    const double most = reflection.model.largest();
    return look.is_creased || look.range > steep * most ||
           std::abs(look.sum.returned - look.sum.lower) > rough * most * share * facet.area;
  }

  // part: what is seen of the facet, or null: all of it. returned: of the whole piece, by its rule.
  template <class Model>
  void add_quarters(const Facet& facet, const PatchPolynomial& surface, const FacetPiece& piece,
                    const SeenParts::Part* part, double returned, int depth, double side,
                    const Reflection<Model>& reflection, CurvedReturn& sum) {
    const auto quarters = piece.quarters();
    std::array<Look, 4> looks;
    CurvedReturn together;
    bool is_creased = false;
    for (std::size_t q = 0; q < quarters.size(); ++q) {
      if (part == nullptr) {
        const auto corners = weights_at(quarters[q].corners(), 0);
        looks[q] = look_at(surface.part(corners, 2.0 * quarters[q].area()), side, reflection);
      } else if (const AreaMoments seen = parts_->seen_within(quarters[q], *part); seen.area != 0.0) {
        looks[q] = look_at(seen_patch(surface, quarters[q], *part, seen), side, reflection);
      }
      together += looks[q].sum;
      is_creased = is_creased || looks[q].is_creased;
    }
    const double share = 2.0 * piece.area(), off = std::abs(together.returned - returned);
    const double enough = alike * reflection.model.largest() * share * facet.area;
    if (depth == 1 || (off <= enough && !is_creased)) {
      sum += together;
      if (is_creased) sum.bound += enough;
      // Beside a crease rules of both degrees may err alike, facet after facet.
      if (depth == 1)
        for (const Look& look : looks) sum.bound += std::abs(look.sum.returned - look.sum.lower);
      else
        sum.bound += off;
      return;
    }
    for (std::size_t q = 0; q < quarters.size(); ++q)
      if (is_rough(looks[q], facet, 0.25 * share, reflection))
        add_quarters(facet, surface, quarters[q], part, looks[q].sum.returned, depth - 1, side, reflection, sum);
      else
        sum += looks[q].sum;
  }

  // corners: places (u, v), one a column. first_corner: the facet's that lies at u = v = 0.
  [[nodiscard]] static std::array<std::array<double, 3>, 3> weights_at(const Eigen::Matrix<double, 2, 3>& corners,
                                                                       std::uint32_t first_corner) {
    std::array<std::array<double, 3>, 3> weights;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto uv = corners.col(static_cast<Eigen::Index>(k));
      weights[k] = {1.0 - uv.x() - uv.y(), uv.x(), uv.y()};
      std::rotate(weights[k].begin(), weights[k].end() - first_corner, weights[k].end());
    }
    return weights;
  }

  // The patch over a triangle that stands for what is seen of a piece: with its area, its middle and its second
  // moments, so that the rule is exact for what varies quadratically. It may reach over the sides; the patch goes on
  // there.
  [[nodiscard]] static CurvedPatch seen_patch(const PatchPolynomial& surface, const FacetPiece& piece,
                                              const SeenParts::Part& part, const AreaMoments& seen) {
    const auto corners = stand_in_for(seen, piece).value_or(piece.corners());
    return surface.part(weights_at(corners, part.first_corner), 2.0 * seen.area);
  }

  template <class Model>
  void add_planar(const Facet& facet, double side, const Reflection<Model>& reflection, CurvedReturn& sum) const {
    const Vec3 n = side * facet.patch.normal[0];
    const double cos_i = n.dot(wi_), cos_r = n.dot(wr_), least = std::min(cos_i, cos_r), area = facet.patch.area[0];
    if (!(least > 0.0)) return;
    const double value = area * (retro_ ? reflection.model.f_cos_cos_retro(std::min(cos_i, 1.0)) : reflection.pair(n));
    sum.returned += value;
    sum.lower += value;
    sum.lit_seen += area;
    sum.seen_area += area * cos_r;
    sum.bound +=
        std::abs(value) * grazing_error(least) + (value != 0.0 ? std::abs(area) * lobe_error(reflection.pair, n) : 0.0);
  }

  // Does a crease run through a patch, its corners included?
  template <class Pair>
  [[nodiscard]] static bool has_crease(const Pair& pair, const CurvedPatch& patch, double side) {
    if constexpr (HasCreases<Pair>) {
      const auto middle = pair.creases(Vec3(side * patch.normal[0]));
      std::array<bool, middle.size()> above{}, below{};
      for (std::size_t corner = 1; corner <= 3; ++corner) {
        const auto near = pair.creases(Vec3(side * patch.normal[corner]));
        for (std::size_t k = 0; k < middle.size(); ++k)
          (middle[k] + CurvedSurface::beyond_places * (near[k] - middle[k]) > 0.0 ? above : below)[k] = true;
      }
      for (std::size_t k = 0; k < middle.size(); ++k)
        if (above[k] && below[k]) return true;
    }
    return false;
  }

  // value: the range of f_r cos_i cos_r [1/sr].
  template <class Model>
  double add(const CurvedPatch& patch, double side, const Reflection<Model>& reflection, CurvedReturn& sum) const {
    const Vec3 wi = side * wi_, wr = side * wr_;
    Lanes area{}, cos_r{}, least{}, values{}, weight{};
    for (std::size_t k = 0; k < PatchRule::size; ++k) {
      area[k] = patch.area[k];
      cos_r[k] = patch.normal[k].dot(wr);
      least[k] = retro_ ? cos_r[k] : std::min(patch.normal[k].dot(wi), cos_r[k]);
    }
    least.back() = 1.0;
    reflection.at(patch, side, retro_, least, values);
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    for (std::size_t k = 0; k < PatchRule::size; ++k) {
      const bool is_faced = least[k] > 0.0;
      weight[k] = is_faced ? rule_.weight[k] * area[k] : 0.0;
      const double value = is_faced ? values[k] : 0.0;
      low = std::min(low, value), high = std::max(high, value);
      sum.returned += weight[k] * value;
      sum.lower += rule_.lower[k] * area[k] * value;
      sum.lit_seen += weight[k];
      sum.seen_area += weight[k] * cos_r[k];
      sum.bound += std::abs(weight[k] * value) * grazing_error(least[k]);
    }
    if constexpr (HasLobeError<decltype(reflection.pair)>)
      for (std::size_t k = 0; k < PatchRule::size; ++k)
        if (least[k] > 0.0 && values[k] != 0.0)
          sum.bound += std::abs(weight[k]) * lobe_error(reflection.pair, Vec3(side * patch.normal[k]));
    return high - low;
  }

  // Of a facet that is turned away in part. Where it turns is a parabola, nearly, in quarters of the facet. Models may
  // end there abruptly for a pair of directions; retro they do not, or need not be known as well.
  template <class Model>
  void add_cut(const Facet& facet, double side, const Reflection<Model>& reflection, CurvedReturn& sum) const {
    const PatchPolynomial surface(facet.patch);
    const RimCut sight{surface, side * wi_, side * wr_};
    add_cut_quarters(sight, {sight.at({1.0, 0.0, 0.0}), sight.at({0.0, 1.0, 0.0}), sight.at({0.0, 0.0, 1.0})},
                     retro_ ? 1 : 2, side, reflection, sum);
    // The line is interpolated: off by a part of the facet of second order in how far the facet turns.
    sum.bound += facet.spread * facet.spread * std::abs(sum.returned);
  }

  // depth: how often a piece through which the turn runs is cut into quarters.
  template <class Model>
  void add_cut_quarters(const RimCut& sight, const std::array<RimCorner, 3>& corners, int depth, double side,
                        const Reflection<Model>& reflection, CurvedReturn& sum) const {
    const auto& [a, b, c] = corners;
    const RimCorner ab = sight.half_way(a, b), bc = sight.half_way(b, c), ca = sight.half_way(c, a);
    for (const std::array<RimCorner, 3>& quarter :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
      if (depth > 1 && is_turned_in_part(quarter)) {
        add_cut_quarters(sight, quarter, depth - 1, side, reflection, sum);
        continue;
      }
      RimPolygon polygon;
      for (const RimCorner& corner : quarter) polygon.add(corner);
      polygon = sight.cut(polygon, &RimCorner::facing_i);
      if (!retro_) polygon = sight.cut(polygon, &RimCorner::facing_r);
      const std::size_t from = polygon.most_reflex();
      for (std::size_t k = 2; k < polygon.size; ++k)
        add(sight.surface.part({polygon.corners[from].at, polygon.after(from, k - 1).at, polygon.after(from, k).at}),
            side, reflection, sum);
    }
  }

  const PatchRule& rule_ = patch_rule();
  const Target& target_;
  std::span<const Estimate> seen_;
  SurfaceFractions fractions_;
  const Vec3 &wi_, &wr_;
  bool retro_;
  SeenParts* parts_;
  std::vector<const SeenParts::Part*> part_of_;  // one a curved facet, where there are parts
};

}  // namespace

std::vector<CurvedReturn> curved_returns(const Target& target, std::span<const Estimate> seen, SeenParts* parts,
                                         const Vec3& to_transmitter, const Vec3& to_receiver) {
  const auto& facets = target.curved.facets();
  std::vector<CurvedReturn> returns(facets.size());
  if (facets.empty()) return returns;
  Looking looking(target, seen, parts, to_transmitter, to_receiver);
  const auto& behind = target.back_material();
  for (std::uint32_t m = 0; m < target.materials.size(); ++m)
    std::visit(
        [&](const auto& model) {
          // Never asks for what was not measured: of facets that only rounding may make visible, and of what is black.
          const auto& always = supposed(model);
          const Reflection seen_as(model, to_transmitter, to_receiver);
          const Reflection unseen_as(always, to_transmitter, to_receiver);
          const auto& reflection = returns_nothing(target.materials[m]) ? unseen_as : seen_as;
          for (std::size_t k = 0; k < facets.size(); ++k)
            if (const std::uint32_t f = facets[k].facet; target.material[f] == m || behind[f] == m)
              returns[k] += looking.at(facets[k], m, reflection, unseen_as);
        },
        target.materials[m].brdf);
  return returns;
}

}  // namespace lrcs
