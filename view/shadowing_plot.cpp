#include "view/shadowing_plot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "view/brdf_axes.h"
#include "view/incidence_family.h"
#include "view/plot_file.h"

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

void draw_shadowing_plot(const std::filesystem::path& file, const std::vector<ShadowingCurves>& materials,
                         const std::string& title, const std::string& note) {
  require_family(materials);
  for (const ShadowingCurves& material : materials)
    for (const ShadowingCurve& curve : material.curves) require_valid(curve);
  const std::size_t incidences = materials.front().curves.size();
  const auto chosen = spread_choice(incidences, most_incidences_of_a_family);
  Canvas canvas = plot_canvas(file, 1600, 1000);
  const double top = draw_header(
      canvas, {title, note + "\n" + choice_note(chosen.size(), incidences), family_legend(materials, chosen)});
  const CartesianFrame frame = draw_cartesian_frame(canvas, top, angle_axis(materials), shadowing_axis());
  for (std::size_t k = chosen.size(); k-- > 0;)
    for (std::size_t m = materials.size(); m-- > 0;) {
      const ShadowingCurve& curve = materials[m].curves[chosen[k]];
      draw_broken_line(canvas, frame, curve.theta_r_deg, curve.shadowing, family_pen(k, m));
    }
  draw_outline(canvas, frame);
  write_plot(file, canvas);
}

}  // namespace lrcs
