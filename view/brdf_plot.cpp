#include "view/brdf_plot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "view/brdf_axes.h"
#include "view/incidence_family.h"
#include "view/plot_file.h"

namespace lrcs {
namespace {

void require_valid(const std::vector<BrdfCurve>& curves) {
  if (curves.empty()) throw std::invalid_argument("a plot needs at least one curve");
  for (const BrdfCurve& curve : curves) {
    if (curve.theta_r_deg.size() != curve.f_r_per_sr.size()) {
      throw std::invalid_argument("a BRDF curve needs as many angles as values");
    }
    const auto finite = [](double angle) { return std::isfinite(angle); };
    const auto negative = [](double f_r) { return f_r < 0.0; };
    if (!std::all_of(curve.theta_r_deg.begin(), curve.theta_r_deg.end(), finite) ||
        std::any_of(curve.f_r_per_sr.begin(), curve.f_r_per_sr.end(), negative)) {
      throw std::invalid_argument("a BRDF curve needs finite angles and no negative value");
    }
  }
}

// A curve with the pen it is drawn with.
struct PennedCurve {
  const BrdfCurve* curve;
  Pen pen;
};

Axis angle_axis(const std::vector<PennedCurve>& curves) {
  Extent extent;
  for (const auto& [curve, pen] : curves)
    for (const double angle : curve->theta_r_deg) extent.take(angle);
  return scattering_axis(extent, signed_scattering_angle);
}

Axis value_axis(const std::vector<PennedCurve>& curves) {
  Extent positive;
  for (const auto& [curve, pen] : curves)
    for (const double f_r : curve->f_r_per_sr)
      if (std::isfinite(f_r) && f_r > 0.0) positive.take(f_r);
  return f_r_axis(positive, positive);
}

void draw(const std::filesystem::path& file, const PlotHeader& header, const std::vector<PennedCurve>& curves) {
  Canvas canvas = plot_canvas(file, 1600, 1000);
  const double top = draw_header(canvas, header);
  const CartesianFrame frame = draw_cartesian_frame(canvas, top, angle_axis(curves), value_axis(curves));
  canvas.clip(frame.box);
  for (std::size_t i = curves.size(); i-- > 0;) {
    const auto& [curve, pen] = curves[i];
    draw_broken_line(canvas, frame, curve->theta_r_deg, curve->f_r_per_sr, pen);
  }
  canvas.no_clip();
  draw_outline(canvas, frame);
  write_plot(file, canvas);
}

PlotHeader header_of(const std::vector<BrdfCurve>& curves, const std::string& title) {
  if (curves.size() == 1) return {title, incidence_label(curves.front().theta_i_deg), {}};
  PlotHeader header{title, "", {}};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    header.legend.push_back({incidence_label(curves[i].theta_i_deg), curve_pen(i)});
  }
  return header;
}

}  // namespace

void draw_brdf_plot(const std::filesystem::path& file, const std::vector<BrdfCurve>& curves, const std::string& title) {
  require_valid(curves);
  std::vector<PennedCurve> penned;
  for (std::size_t i = 0; i < curves.size(); ++i) penned.push_back({&curves[i], curve_pen(i)});
  draw(file, header_of(curves, title), penned);
}

void draw_brdf_comparison(const std::filesystem::path& file, const std::vector<BrdfCurves>& materials,
                          const std::string& title) {
  require_family(materials);
  for (const BrdfCurves& material : materials) require_valid(material.curves);
  const std::size_t incidences = materials.front().curves.size();
  const auto chosen = spread_choice(incidences, most_incidences_of_a_family);
  std::vector<PennedCurve> penned;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    for (std::size_t m = 0; m < materials.size(); ++m)
      penned.push_back({&materials[m].curves[chosen[k]], family_pen(k, m)});
  draw(file, {title, choice_note(chosen.size(), incidences), family_legend(materials, chosen)}, penned);
}

}  // namespace lrcs
