#include "cli/brdf_pictures.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "base/input_error.h"
#include "brdf/brdf_table.h"
#include "brdf/shadowing.h"
#include "cli/flag_words.h"
#include "cli/plane_curves.h"
#include "view/brdf_plot.h"
#include "view/brdf_surface.h"
#include "view/incidence_family.h"
#include "view/shadowing_plot.h"

namespace lrcs {
namespace {

constexpr double steepest_of_surface = 80.0;  // theta_r; nearer to grazing f_r may hide all else [deg]

void require_shadowing(const std::string& flag, const Material& material) {
  if (has_shadowing(material.brdf)) return;
  throw InputError(fmt::format("{}: expected a material with a shadowing function, found '{}', model {}", flag,
                               material.name, description_of(material.brdf)));
}

// Not a number, at which the curve breaks, where it was not measured.
double f_r_if_known(const Brdf& brdf, double theta_i_deg, double theta_r_deg) {
  try {
    return f_r_in_plane(brdf, theta_i_deg, theta_r_deg);
  } catch (const NotMeasured&) {
    return std::nan("");
  }
}

BrdfCurve brdf_curve(const Material& material, double theta_i_deg) {
  constexpr int last = 170;  // 85 deg
  BrdfCurve curve{theta_i_deg, half_degrees(last), {}};
  for (const double r_deg : curve.theta_r_deg)
    curve.f_r_per_sr.push_back(f_r_if_known(material.brdf, theta_i_deg, r_deg));
  return curve;
}

// A picture whose values are there: draws it.
using Drawing = std::function<void()>;

Drawing curves_drawing(const std::string& png, const std::vector<Material>& materials,
                       const std::vector<double>& theta_i_deg) {
  std::vector<BrdfCurves> values;
  for (const Material& material : materials) {
    values.push_back({material.name, {}});
    for (const double angle : theta_i_deg) values.back().curves.push_back(brdf_curve(material, angle));
  }
  if (values.size() > 1) return [=] { draw_brdf_comparison(png, values, "BRDF in the plane of incidence"); };
  const std::string title = fmt::format("BRDF of {} in the plane of incidence", materials.front().name);
  return [=] { draw_brdf_plot(png, values.front().curves, title); };
}

Drawing shadowing_drawing(const std::string& png, const std::vector<Material>& materials,
                          const std::vector<double>& theta_i_deg) {
  std::vector<ShadowingCurves> values;
  values.reserve(materials.size());
  for (const Material& material : materials)
    values.push_back(shadowing_curves(material.name, material.brdf, theta_i_deg));
  const std::string of = materials.size() > 1 ? "" : fmt::format(" of {}", materials.front().name);
  return [=] { draw_shadowing_plot(png, values, fmt::format("Shadowing function{} in the plane of incidence", of)); };
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

Drawing surface_drawing(const std::string& png, const Material& material, double theta_i_deg) {
  const auto f_r = [&](double theta_r, double phi) {
    return f_r_angles(material.brdf, theta_i_deg * degree, theta_r, phi);
  };
  const SurfaceText text{fmt::format("BRDF of {}", material.name), surface_note(theta_i_deg), "BRDF [1/sr]"};
  return [=, values = over_directions(theta_i_deg, f_r)] { draw_brdf_surface(png, values, text); };
}

Drawing surface_shadowing_drawing(const std::string& png, const Material& material, double theta_i_deg) {
  const auto g = [&](double theta_r, double phi) {
    return shadowing_angles(material.brdf, theta_i_deg * degree, theta_r, phi).value();
  };
  const SurfaceText text{fmt::format("Shadowing function of {}", material.name), surface_note(theta_i_deg),
                         "shadowing function G", 1.0};
  return [=, values = over_directions(theta_i_deg, g)] { draw_brdf_surface(png, values, text); };
}

// Where an option names a file at all; no two the same one.
void require_png_files(const BrdfPictures& pictures) {
  std::map<std::filesystem::path, std::string> flag_of;
  for (const auto& [flag, png] : {std::pair{"--output", &pictures.curves},
                                  {"--shadowing", &pictures.shadowing},
                                  {"--surface", &pictures.surface},
                                  {"--surface-shadowing", &pictures.surface_shadowing}}) {
    if (png->empty()) continue;
    require_output_file(*png, flag, {".png", ".svg"});
    const auto [other, is_new] =
        flag_of.emplace(std::filesystem::weakly_canonical(std::filesystem::absolute(*png)), flag);
    if (!is_new)
      throw InputError(fmt::format("{}: would overwrite the picture of {}, '{}'", flag, other->second, *png));
  }
}

}  // namespace

void require_drawable(const BrdfPictures& pictures, const std::vector<Material>& materials) {
  require_png_files(pictures);
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
  std::vector<Drawing> drawings;
  const Material& first = materials.front();
  if (!pictures.curves.empty()) drawings.push_back(curves_drawing(pictures.curves, materials, theta_i_deg));
  if (!pictures.shadowing.empty()) drawings.push_back(shadowing_drawing(pictures.shadowing, materials, theta_i_deg));
  if (!pictures.surface.empty()) drawings.push_back(surface_drawing(pictures.surface, first, theta_i_deg.front()));
  if (!pictures.surface_shadowing.empty())
    drawings.push_back(surface_shadowing_drawing(pictures.surface_shadowing, first, theta_i_deg.front()));
  for (const Drawing& draw : drawings) draw();
}

}  // namespace lrcs
