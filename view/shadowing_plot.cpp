#include "view/shadowing_plot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "view/brdf_axes.h"
#include "view/incidence_family.h"

namespace lrcs {
namespace {

void require_valid(const ShadowingCurve& curve) {
  if (curve.theta_r_deg.empty() || curve.theta_r_deg.size() != curve.shadowing.size())
    throw std::invalid_argument("a shadowing curve needs as many angles as values, at least one");
  const auto finite = [](double angle) { return std::isfinite(angle); };
  const auto share = [](double g) { return g >= 0.0 && g <= 1.0; };
  if (!finite(curve.theta_i_deg) || !std::all_of(curve.theta_r_deg.begin(), curve.theta_r_deg.end(), finite) ||
      !std::all_of(curve.shadowing.begin(), curve.shadowing.end(), share))
    throw std::invalid_argument("a shadowing curve needs finite angles and G in [0, 1]");
}

void require_valid(const std::vector<ShadowingCurves>& materials) {
  if (materials.empty() || materials.size() > most_materials_in_a_plot)
    throw std::invalid_argument("a shadowing plot needs one to six materials");
  const auto same_angle = [](const ShadowingCurve& a, const ShadowingCurve& b) {
    return a.theta_i_deg == b.theta_i_deg;
  };
  const auto& first = materials.front().curves;
  if (first.empty()) throw std::invalid_argument("a plot needs at least one curve");
  for (const ShadowingCurves& material : materials) {
    for (const ShadowingCurve& curve : material.curves) require_valid(curve);
    if (!std::equal(first.begin(), first.end(), material.curves.begin(), material.curves.end(), same_angle))
      throw std::invalid_argument("a shadowing plot needs the same incidence angles of every material");
  }
}

std::vector<LegendEntry> legend_of(const std::vector<ShadowingCurves>& materials,
                                   const std::vector<std::size_t>& chosen) {
  const auto& first = materials.front().curves;
  std::vector<double> theta_i_deg(chosen.size());
  std::vector<std::string> names(materials.size());
  std::transform(chosen.begin(), chosen.end(), theta_i_deg.begin(), [&](auto i) { return first[i].theta_i_deg; });
  std::transform(materials.begin(), materials.end(), names.begin(), [](const auto& m) { return m.material; });
  return family_legend(theta_i_deg, names);
}

Axis angle_axis(const std::vector<ShadowingCurves>& materials) {
  Extent extent;
  for (const ShadowingCurves& material : materials)
    for (const ShadowingCurve& curve : material.curves)
      for (const double angle : curve.theta_r_deg) extent.take(angle);
  return scattering_axis(extent, signed_scattering_angle);
}

// With room for a line along G = 1.
Axis shadowing_axis() {
  Axis axis = linear_axis("shadowing function G", 0.0, 1.0);
  axis.high = 1.04;
  return axis;
}

}  // namespace

void draw_shadowing_plot(const std::filesystem::path& png, const std::vector<ShadowingCurves>& materials,
                         const std::string& title) {
  require_valid(materials);
  constexpr std::size_t most_incidences = 7;
  const std::size_t incidences = materials.front().curves.size();
  const auto chosen = spread_choice(incidences, most_incidences);
  Canvas canvas(1600, 1000);
  const double top = draw_header(canvas, {title, choice_note(chosen.size(), incidences), legend_of(materials, chosen)});
  const CartesianFrame frame = draw_cartesian_frame(canvas, top, angle_axis(materials), shadowing_axis());
  for (std::size_t k = chosen.size(); k-- > 0;)
    for (std::size_t m = materials.size(); m-- > 0;) {
      const ShadowingCurve& curve = materials[m].curves[chosen[k]];
      draw_broken_line(canvas, frame, curve.theta_r_deg, curve.shadowing, family_pen(k, m));
    }
  draw_outline(canvas, frame);
  write_png(png, canvas.picture());
}

}  // namespace lrcs
