#include "cli/brdf_pictures.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <set>

#include "base/input_error.h"
#include "brdf/brdf_table.h"
#include "brdf/shadowing.h"
#include "view/brdf_plot.h"
#include "view/brdf_surface.h"
#include "view/incidence_family.h"
#include "view/shadowing_plot.h"

namespace lrcs {
namespace {

constexpr double steepest_of_surface = 80.0;  // theta_r; nearer to grazing f_r may hide all else [deg]

bool has_shadowing(const Material& material) {
  return shadowing_angles(material.brdf, 0.0, 0.0, 0.0).has_value();
}

void require_shadowing(const std::string& flag, const Material& material) {
  if (has_shadowing(material)) return;
  throw InputError(fmt::format("{}: expected a material with a shadowing function, found '{}', model {}", flag,
                               material.name, description_of(material.brdf)));
}

// In the plane of incidence; as in the table a negative theta_r is the specular side. steps: of half a degree.
std::vector<double> signed_angles(int steps) {
  std::vector<double> theta_r_deg;
  for (int k = -steps; k <= steps; ++k) theta_r_deg.push_back(0.5 * k);
  return theta_r_deg;
}

double phi_of(double signed_theta_r_deg) {
  return signed_theta_r_deg < 0.0 ? 180.0 * degree : 0.0;
}

// Not a number, at which the curve breaks, where it was not measured.
double f_r_if_known(const Brdf& brdf, double theta_i_deg, double signed_theta_r_deg) {
  try {
    return f_r_angles(brdf, theta_i_deg * degree, std::abs(signed_theta_r_deg) * degree, phi_of(signed_theta_r_deg));
  } catch (const NotMeasured&) {
    return std::nan("");
  }
}

BrdfCurve brdf_curve(const Material& material, double theta_i_deg) {
  BrdfCurve curve{theta_i_deg, signed_angles(170), {}};
  for (const double r_deg : curve.theta_r_deg)
    curve.f_r_per_sr.push_back(f_r_if_known(material.brdf, theta_i_deg, r_deg));
  return curve;
}

ShadowingCurve shadowing_curve(const Material& material, double theta_i_deg) {
  ShadowingCurve curve{theta_i_deg, signed_angles(178), {}};
  for (const double r_deg : curve.theta_r_deg)
    curve.shadowing.push_back(
        shadowing_angles(material.brdf, theta_i_deg * degree, std::abs(r_deg) * degree, phi_of(r_deg)).value());
  return curve;
}

void draw_curves(const std::string& png, const std::vector<Material>& materials,
                 const std::vector<double>& theta_i_deg) {
  std::vector<BrdfCurves> drawn;
  for (const Material& material : materials) {
    drawn.push_back({material.name, {}});
    for (const double angle : theta_i_deg) drawn.back().curves.push_back(brdf_curve(material, angle));
  }
  if (drawn.size() > 1) return draw_brdf_comparison(png, drawn, "BRDF in the plane of incidence");
  draw_brdf_plot(png, drawn.front().curves,
                 fmt::format("BRDF of {} in the plane of incidence", materials.front().name));
}

void draw_shadowing(const std::string& png, const std::vector<Material>& materials,
                    const std::vector<double>& theta_i_deg) {
  std::vector<ShadowingCurves> drawn;
  for (const Material& material : materials) {
    drawn.push_back({material.name, {}});
    for (const double angle : theta_i_deg) drawn.back().curves.push_back(shadowing_curve(material, angle));
  }
  const std::string of = materials.size() > 1 ? "" : fmt::format(" of {}", materials.front().name);
  draw_shadowing_plot(png, drawn, fmt::format("Shadowing function{} in the plane of incidence", of));
}

// Angles in steps, and finer ones about an angle at which a narrow lobe may stand. [deg]
std::set<double> graded(double last, double step, double about, double fine_step) {
  std::set<double> angles;
  for (double angle = 0.0; angle <= last; angle += step) angles.insert(angle);
  constexpr int fine_steps = 10;
  for (int k = -fine_steps; k <= fine_steps; ++k) {
    const double angle = about + k * fine_step;
    if (angle >= 0.0 && angle <= last) angles.insert(angle);
  }
  return angles;
}

HemisphereValues over_directions(double theta_i_deg, const std::function<double(double theta_r, double phi)>& value) {
  const auto theta = graded(steepest_of_surface, 1.0, theta_i_deg, 0.1);
  const auto phi = graded(358.0, 2.0, 180.0, 0.2);
  HemisphereValues values{{theta.begin(), theta.end()}, {phi.begin(), phi.end()}, {}};
  for (const double r_deg : theta)
    for (const double phi_deg : phi) values.value.push_back(value(r_deg * degree, phi_deg * degree));
  return values;
}

std::string surface_note(double theta_i_deg) {
  return fmt::format("incidence {}°: transmitter at phi 0°, specular side at phi 180°; rim at theta_r {}°", theta_i_deg,
                     steepest_of_surface);
}

void draw_surface(const std::string& png, const Material& material, double theta_i_deg) {
  const auto f_r = [&](double theta_r, double phi) {
    return f_r_angles(material.brdf, theta_i_deg * degree, theta_r, phi);
  };
  draw_brdf_surface(png, over_directions(theta_i_deg, f_r),
                    {fmt::format("BRDF of {}", material.name), surface_note(theta_i_deg), "BRDF [1/sr]"});
}

void draw_surface_shadowing(const std::string& png, const Material& material, double theta_i_deg) {
  const auto g = [&](double theta_r, double phi) {
    return shadowing_angles(material.brdf, theta_i_deg * degree, theta_r, phi).value();
  };
  draw_brdf_surface(
      png, over_directions(theta_i_deg, g),
      {fmt::format("Shadowing function of {}", material.name), surface_note(theta_i_deg), "shadowing function G", 1.0});
}

}  // namespace

void require_drawable(const BrdfPictures& pictures, const std::vector<Material>& materials) {
  if (materials.size() > most_materials_in_a_plot)
    throw InputError(fmt::format("--with: expected at most {} materials, found {}", most_materials_in_a_plot - 1,
                                 materials.size() - 1));
  if (materials.size() > 1 && pictures.curves.empty() && pictures.shadowing.empty())
    throw InputError("--with: expected beside --output or --shadowing");
  if (!pictures.surface_shadowing.empty()) require_shadowing("--surface-shadowing", materials.front());
  if (pictures.shadowing.empty()) return;
  for (const Material& material : materials) require_shadowing("--shadowing", material);
}

void draw_brdf_pictures(const BrdfPictures& pictures, const std::vector<Material>& materials,
                        const std::vector<double>& theta_i_deg) {
  if (!pictures.curves.empty()) draw_curves(pictures.curves, materials, theta_i_deg);
  if (!pictures.shadowing.empty()) draw_shadowing(pictures.shadowing, materials, theta_i_deg);
  if (!pictures.surface.empty()) draw_surface(pictures.surface, materials.front(), theta_i_deg.front());
  if (!pictures.surface_shadowing.empty())
    draw_surface_shadowing(pictures.surface_shadowing, materials.front(), theta_i_deg.front());
}

}  // namespace lrcs
