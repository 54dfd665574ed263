#include "lrcs/cross_section.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "base/compensated_sum.h"
#include "lrcs/curved_returns.h"
#include "lrcs/return_error.h"
#include "lrcs/seen_parts.h"

namespace lrcs {
namespace {

// f_r cos(theta_i) cos(theta_r) of every facet that is seen from a side of one material; the largest value of its sides
// where it is perhaps edge-on. Others are left alone. Adds what rounding may do to lobes to `lobes`, times the areas
// seen.
void reflect(const Target& target, std::uint32_t material, const Vec3& wi, const Vec3& wr,
             const std::vector<Estimate>& seen, std::vector<double>& out, CompensatedSum& lobes) {
  if (returns_nothing(target.materials[material])) return;
  const bool retro = wi == wr;
  const auto& behind = target.back_material();
  std::visit(
      [&](const auto& model) {
        const auto pair = model.for_pair(wi, wr);
        const auto& unseen = supposed(model);  // of facets that only rounding may make visible
        for (std::size_t k = 0; k < out.size(); ++k) {
          if (target.material[k] != material && behind[k] != material) continue;
          if (seen[k].value == 0.0 && seen[k].bound == 0.0) continue;
          if (target.curved.place_of(k) != CurvedSurface::none) continue;
          const double cos_i = target.mesh.normals[k].dot(wi);
          const bool perhaps_edge_on = seen[k].value == 0.0 && seen[k].bound == 1.0;
          for (const double side : {1.0, -1.0}) {
            if (side < 0.0 && target.sides == Sides::front) continue;
            if ((side > 0.0 ? target.material : behind)[k] != material) continue;
            if ((cos_i < 0.0) != (side < 0.0) && !perhaps_edge_on) continue;
            const Vec3 n = side * target.mesh.normals[k];
            double returned = 0.0;
            if (retro)
              returned = (seen[k].value > 0.0 ? model : unseen).f_cos_cos_retro(std::abs(cos_i));
            else if (perhaps_edge_on)
              returned = largest_edge_on(unseen.for_pair(wi, wr), n, wi, wr);
            else
              returned = seen[k].value > 0.0 ? pair(n) : unseen.f_cos_cos(wi, wr, n);
            out[k] = std::max(out[k], returned);
            if constexpr (HasLobeError<decltype(pair)>)
              if (returned > 0.0 && !perhaps_edge_on)
                lobes.add(pair.lobe_error(n) * target.mesh.areas[k] * (seen[k].value + seen[k].bound));
          }
        }
      },
      target.materials[material].brdf);
}

}  // namespace

bool Target::has_one_material() const {
  const auto is_first = [this](std::uint32_t m) { return m == material.front(); };
  return std::all_of(material.begin(), material.end(), is_first) &&
         (sides == Sides::front || std::all_of(back.begin(), back.end(), is_first));
}

CrossSection cross_section(const Target& target, const Visibility& visibility, const Vec3& to_transmitter,
                           const Vec3& to_receiver) {
  CrossSection result;
  std::vector<Estimate> seen;
  SeenParts parts;
  visibility.seen_fraction(to_transmitter, to_receiver, seen, nullptr, &parts);
  cross_section(target, seen, to_transmitter, to_receiver, result, &parts);
  return result;
}

CrossSection cross_section(const Target& target, const std::vector<Estimate>& seen, const Vec3& to_transmitter,
                           const Vec3& to_receiver) {
  CrossSection result;
  cross_section(target, seen, to_transmitter, to_receiver, result);
  return result;
}

void cross_section(const Target& target, const std::vector<Estimate>& seen, const Vec3& to_transmitter,
                   const Vec3& to_receiver, CrossSection& result, SeenParts* parts) {
  const std::size_t facets = target.mesh.size();
  auto& reflected = result.facet_sigma;
  reflected.assign(facets, 0.0);
  CompensatedSum lobes;
  for (std::uint32_t m = 0; m < target.materials.size(); ++m)
    reflect(target, m, to_transmitter, to_receiver, seen, reflected, lobes);
  const double of_pair = pair_error(target.materials, to_transmitter, to_receiver);

  const auto curved = curved_returns(target, seen, parts, to_transmitter, to_receiver);
  result.seen_fraction.resize(facets);
  CompensatedSum sigma, bound, seen_area, remains, squares;
  for (std::size_t k = 0; k < facets; ++k) {
    result.seen_fraction[k] = seen[k].value;
    if (const std::uint32_t place = target.curved.place_of(k); place != CurvedSurface::none) {
      const CurvedReturn& c = curved[place];
      const double whole = target.curved.facets()[place].area;
      result.seen_fraction[k] = whole > 0.0 ? std::clamp(c.lit_seen / whole, 0.0, 1.0) : 0.0;
      result.facet_sigma[k] = 4.0 * std::numbers::pi * c.returned;
      sigma.add(result.facet_sigma[k]);
      seen_area.add(c.seen_area);
      bound.add(4.0 * std::numbers::pi * (c.bound + of_pair * std::abs(c.returned)));
      const double rest = 4.0 * std::numbers::pi * (c.returned - c.lower);
      remains.add(rest);
      squares.add(rest * rest);
      continue;
    }
    if (seen[k].value == 0.0 && reflected[k] == 0.0) continue;
    const double cos_i = target.mesh.normals[k].dot(to_transmitter);
    const double cos_r = target.mesh.normals[k].dot(to_receiver);
    const double area = target.mesh.areas[k];
    const double full = 4.0 * std::numbers::pi * area * reflected[k];
    result.facet_sigma[k] = full * seen[k].value;
    sigma.add(result.facet_sigma[k]);
    seen_area.add(area * seen[k].value * std::abs(cos_r));
    const double grazing = std::min(std::abs(cos_i), std::abs(cos_r));
    const double relative = of_pair + grazing_error(grazing);
    bound.add(full * (seen[k].bound + seen[k].value * relative));
  }
  const double of_curvature = std::abs(remains.value()) + std::sqrt(squares.value());
  result.sigma = {sigma.value(), bound.value() + 4.0 * std::numbers::pi * lobes.value() + of_curvature};
  result.seen_area = seen_area.value();
}

}  // namespace lrcs
