#include "lrcs/convex_body.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "lrcs/retro_sums.h"
#include "lrcs/return_error.h"

namespace lrcs {
namespace {

// Blocks whose sums are kept in plain lanes before they are added with compensation: they fit the nearest cache.
constexpr std::size_t chunk_blocks = 16;

// model_error, and what it leaves out here: the facets that are perhaps edge-on, whose return is that of a cosine up to
// 16 units larger (a tenth), and the plain sums of a chunk.
constexpr double block_error = model_error + 128.0 * 0x1p-53;

// The lowest ten bits, with two zeros after each.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16U)) & 0x030000ffU;
  x = (x | (x << 8U)) & 0x0300f00fU;
  x = (x | (x << 4U)) & 0x030c30c3U;
  return (x | (x << 2U)) & 0x09249249U;
}

// Along a curve through space (Morton's), so that like normals come one after another, and equal ones together.
std::uint32_t place_on_curve(const Vec3& normal) {
  const auto cell = [](double x) { return static_cast<std::uint32_t>(std::clamp((x + 1.0) * 511.5, 0.0, 1023.0)); };
  return spread(cell(normal.x())) | (spread(cell(normal.y())) << 1U) | (spread(cell(normal.z())) << 2U);
}

std::vector<std::uint32_t> order_by_material_and_normal(const Target& target) {
  using Key = std::pair<std::uint64_t, std::uint32_t>;
  std::vector<Key> keys;
  for (std::uint32_t f = 0; f < target.mesh.size(); ++f)
    if (target.mesh.areas[f] > 0.0)
      keys.emplace_back((std::uint64_t{target.material[f]} << 32U) | place_on_curve(target.mesh.normals[f]), f);
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const Key& key : keys) order.push_back(key.second);
  return order;
}

void put(FacetBlock& block, const Vec3& normal, double area) {
  const std::size_t k = block.facets++;
  block.nx[k] = normal.x(), block.ny[k] = normal.y(), block.nz[k] = normal.z();
  block.area[k] = area;
  block.low = k == 0 ? normal : Vec3(block.low.cwiseMin(normal));
  block.high = k == 0 ? normal : Vec3(block.high.cwiseMax(normal));
}

bool is_turned_away(const FacetBlock& block, const Aspect& aspect, bool monostatic) {
  return block.most(aspect.to_receiver) <= -doubtful_cosine ||
         (!monostatic && block.most(aspect.to_transmitter) <= -doubtful_cosine);
}

// Of models that have no form for vector code.
template <class Model>
void add_retro_one_by_one(const FacetBlock& block, const Vec3& d, const Model& model, LaneSums& sums) {
  const auto pair = model.for_pair(d, d);
  for (std::size_t k = 0; k < block.facets; ++k) {
    const double cosine = std::min(block.cosine(k, d), 1.0);
    if (cosine <= -doubtful_cosine) continue;
    const double above = std::max(cosine, smallest_retro_cosine);
    const double returns = block.area[k] * (model.f_cos_cos_retro(above) / above);
    sums.returned[k] += returns * std::max(cosine, 0.0);
    sums.seen[k] += block.area[k] * std::max(cosine, 0.0);
    sums.slope[k] += returns + block.area[k] * (lobe_error(pair, block.normal(k)) / block_error);
  }
}

// What is lit and seen of a block, its return left out.
void add_seen(const FacetBlock& block, const Aspect& aspect, LaneSums& sums) {
  for (std::size_t k = 0; k < block_facets; ++k)
    if (block.cosine(k, aspect.to_transmitter) > doubtful_cosine)
      sums.seen[k] += block.area[k] * std::max(block.cosine(k, aspect.to_receiver), 0.0);
}

// Returns the most that facets seen edge-on, as far as rounding can tell, may return; they are left out of the sums.
template <class Pair>
double add_pair(const FacetBlock& block, const Aspect& aspect, const Pair& pair, LaneSums& sums) {
  const Vec3 &di = aspect.to_transmitter, &dr = aspect.to_receiver;
  double edge_on = 0.0;
  for (std::size_t k = 0; k < block.facets; ++k) {
    const double least = std::min(block.cosine(k, di), block.cosine(k, dr));
    if (least <= -doubtful_cosine) continue;
    const Vec3 n = block.normal(k);
    if (least <= doubtful_cosine) {
      if (is_exactly_edge_on(n, di) || is_exactly_edge_on(n, dr)) continue;
      edge_on += block.area[k] * largest_edge_on(pair, n, di, dr);
      continue;
    }
    const double returned = block.area[k] * pair(n);
    sums.returned[k] += returned;
    sums.seen[k] += block.area[k] * block.cosine(k, dr);
    sums.slope[k] += returned / least + block.area[k] * (lobe_error(pair, n) / block_error);
  }
  return edge_on;
}

template <class Model>
using PairOf = decltype(std::declval<const Model&>().for_pair(Vec3(), Vec3()));

// BlackRetro, or the pair form of one of the models.
template <class... Models>
std::variant<BlackRetro, PairOf<Models>...> pair_of_any(const std::variant<Models...>* /*list*/);

}  // namespace

struct ConvexBody::Sums {
  Sums(const Target& target, const Aspect& aspect) : monostatic(aspect.to_transmitter == aspect.to_receiver) {
    if (monostatic) return;
    for (const Material& m : target.materials)
      pairs.push_back(std::visit(
          [&](const auto& model) {
            return returns_nothing(m) ? Pair() : Pair(model.for_pair(aspect.to_transmitter, aspect.to_receiver));
          },
          m.brdf));
  }

  using Pair = decltype(pair_of_any(static_cast<const Brdf*>(nullptr)));
  bool monostatic;
  std::vector<Pair> pairs;  // bistatic: one a material
  CarriedLanes returned, seen, slope;
  double edge_on = 0.0;

  void add(const LaneSums& lanes) {
    returned.add(lanes.returned);
    seen.add(lanes.seen);
    slope.add(lanes.slope);
  }
};

ConvexBody::ConvexBody(const Target& target) : target_(target) {
  const auto order = order_by_material_and_normal(target);
  blocks_.reserve(order.size() / block_facets + target.materials.size());
  for (const std::uint32_t f : order) {
    const std::uint32_t material = target.material[f];
    if (blocks_.empty() || blocks_.back().facets == block_facets || blocks_.back().material != material)
      blocks_.emplace_back().material = material;
    put(blocks_.back(), target.mesh.normals[f], target.mesh.areas[f]);
  }
  for (const Material& m : target.materials)
    retro_.push_back(std::visit(
        [&](const auto& model) -> Retro {
          if (returns_nothing(m)) return BlackRetro{};
          if (const auto form = retro_form(model)) return *form;
          return &m.brdf;
        },
        m.brdf));
}

void ConvexBody::add_monostatic(const FacetBlock& block, const Vec3& d, LaneSums& sums) const {
  const Retro& retro = retro_[block.material];
  const bool all_lit = block.facets == block_facets && block.least(d) >= smallest_retro_cosine;
  std::visit(
      [&](const auto& form) {
        if constexpr (std::is_same_v<decltype(form), const Brdf* const&>)
          std::visit([&](const auto& model) { add_retro_one_by_one(block, d, model, sums); }, *form);
        else
          add_retro(block, d, all_lit, form, sums);
      },
      retro);
}

void ConvexBody::add_bistatic(const FacetBlock& block, const Aspect& aspect, Sums& sums, LaneSums& lanes) const {
  std::visit(
      [&](const auto& pair) {
        if constexpr (std::is_same_v<decltype(pair), const BlackRetro&>)
          add_seen(block, aspect, lanes);
        else
          sums.edge_on += add_pair(block, aspect, pair, lanes);
      },
      sums.pairs[block.material]);
}

std::vector<ConvexBody::Section> ConvexBody::sections(std::span<const Aspect> aspects,
                                                      std::vector<std::uint8_t>& faced) const {
  std::vector<Sums> sums;
  for (const Aspect& aspect : aspects) sums.emplace_back(target_, aspect);
  for (std::size_t first = 0; first < blocks_.size(); first += chunk_blocks)
    for (std::size_t a = 0; a < aspects.size(); ++a) {
      LaneSums lanes;
      for (std::size_t b = first; b < std::min(first + chunk_blocks, blocks_.size()); ++b) {
        if (is_turned_away(blocks_[b], aspects[a], sums[a].monostatic)) continue;
        faced[b] = 1;
        if (sums[a].monostatic)
          add_monostatic(blocks_[b], aspects[a].to_receiver, lanes);
        else
          add_bistatic(blocks_[b], aspects[a], sums[a], lanes);
      }
      sums[a].add(lanes);
    }
  std::vector<Section> sections;
  for (std::size_t a = 0; a < aspects.size(); ++a) {
    const double pair = pair_error(target_.materials, aspects[a].to_transmitter, aspects[a].to_receiver);
    const double returned = sums[a].returned.total();
    const double error = block_error * sums[a].slope.total() + pair * returned + sums[a].edge_on;
    sections.push_back({{4.0 * std::numbers::pi * returned, 4.0 * std::numbers::pi * error}, sums[a].seen.total()});
  }
  return sections;
}

std::vector<Estimate> convex_seen_fraction(const FacetMesh& mesh, const Vec3& to_transmitter, const Vec3& to_receiver) {
  std::vector<Estimate> seen(mesh.size());
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    const Vec3& n = mesh.normals[f];
    const double least = std::min(n.dot(to_transmitter), n.dot(to_receiver));
    if (least <= -doubtful_cosine || is_exactly_edge_on(n, to_transmitter) || is_exactly_edge_on(n, to_receiver))
      continue;
    seen[f] = least > doubtful_cosine ? Estimate{1.0, 0.0} : Estimate{0.0, 1.0};
  }
  return seen;
}

}  // namespace lrcs
