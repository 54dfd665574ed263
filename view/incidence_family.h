#pragma once
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "view/plot_header.h"

namespace lrcs {

// Curves of several incidence angles and several materials in one plot: the colour tells the angle, the dashes the
// material.

inline constexpr std::size_t most_materials_in_a_plot = 6;
inline constexpr std::size_t most_incidences_of_a_family = 7;  // as many as there are colours

// `most` indices of 0..count-1, evenly spread, both ends among them; all where there are no more. domain: most >= 2.
[[nodiscard]] std::vector<std::size_t> spread_choice(std::size_t count, std::size_t most);

// "8 of 23 incidence angles are drawn"; nothing where all are.
[[nodiscard]] std::string choice_note(std::size_t drawn, std::size_t count);

// domain: material < most_materials_in_a_plot.
[[nodiscard]] Pen family_pen(std::size_t incidence, std::size_t material);

// A row of angles in their colours, then a row of materials in their dashes where there are several.
[[nodiscard]] std::vector<LegendEntry> family_legend(const std::vector<double>& theta_i_deg,
                                                     const std::vector<std::string>& materials);

// The same of materials with curves (BrdfCurves, ShadowingCurves): of the incidence angles these.
template <class Material>
[[nodiscard]] std::vector<LegendEntry> family_legend(const std::vector<Material>& materials,
                                                     const std::vector<std::size_t>& incidences) {
  std::vector<double> theta_i_deg;
  std::vector<std::string> names;
  theta_i_deg.reserve(incidences.size());
  for (const std::size_t i : incidences) theta_i_deg.push_back(materials.front().curves[i].theta_i_deg);
  names.reserve(materials.size());
  for (const Material& material : materials) names.push_back(material.material);
  return family_legend(theta_i_deg, names);
}

// error: std::invalid_argument unless there are one to six materials, with the same incidence angles in the same order.
template <class Material>
void require_family(const std::vector<Material>& materials) {
  if (materials.empty() || materials.size() > most_materials_in_a_plot)
    throw std::invalid_argument("a plot needs one to six materials");
  const auto same_angle = [](const auto& a, const auto& b) { return a.theta_i_deg == b.theta_i_deg; };
  const auto& first = materials.front().curves;
  if (first.empty()) throw std::invalid_argument("a plot needs at least one curve");
  for (const Material& material : materials)
    if (!std::equal(first.begin(), first.end(), material.curves.begin(), material.curves.end(), same_angle))
      throw std::invalid_argument("a plot needs the same incidence angles of every material");
}

}  // namespace lrcs
