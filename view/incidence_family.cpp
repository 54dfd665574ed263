#include "view/incidence_family.h"

#include <array>
#include <cassert>

#include "view/brdf_axes.h"

namespace lrcs {

std::vector<std::size_t> spread_choice(std::size_t count, std::size_t most) {
  const std::size_t chosen = std::min(count, most);
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < chosen; ++k)
    indices.push_back(count <= most ? k : (k * (count - 1) + (most - 1) / 2) / (most - 1));
  return indices;
}

std::string choice_note(std::size_t drawn, std::size_t count) {
  if (drawn == count) return "";
  return std::to_string(drawn) + " of " + std::to_string(count) + " incidence angles are drawn";
}

Pen family_pen(std::size_t incidence, std::size_t material) {
  static const std::array<std::vector<double>, most_materials_in_a_plot> dashes{
      {{}, {22.0, 14.0}, {4.0, 11.0}, {24.0, 11.0, 4.0, 11.0}, {48.0, 16.0}, {24.0, 11.0, 4.0, 11.0, 4.0, 11.0}}};
  assert(material < dashes.size());
  return {curve_colour(incidence), 5.0, dashes[material]};
}

std::vector<LegendEntry> family_legend(const std::vector<double>& theta_i_deg,
                                       const std::vector<std::string>& materials) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < theta_i_deg.size(); ++i)
    legend.push_back({incidence_label(theta_i_deg[i]), family_pen(i, 0)});
  for (std::size_t m = 0; materials.size() > 1 && m < materials.size(); ++m) {
    Pen pen = family_pen(0, m);
    pen.colour = ink;
    legend.push_back({materials[m], pen, {}, m == 0});
  }
  return legend;
}

}  // namespace lrcs
