#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "view/plot_header.h"

namespace lrcs {

// Curves of several incidence angles and several materials in one plot: the colour tells the angle, the dashes the
// material.

inline constexpr std::size_t most_materials_in_a_plot = 6;

// `most` indices of 0..count-1, evenly spread, both ends among them; all where there are no more. domain: most >= 2.
[[nodiscard]] std::vector<std::size_t> spread_choice(std::size_t count, std::size_t most);

// "8 of 23 incidence angles are drawn"; nothing where all are.
[[nodiscard]] std::string choice_note(std::size_t drawn, std::size_t count);

// domain: material < most_materials_in_a_plot.
[[nodiscard]] Pen family_pen(std::size_t incidence, std::size_t material);

// A row of angles in their colours, then a row of materials in their dashes where there are several.
[[nodiscard]] std::vector<LegendEntry> family_legend(const std::vector<double>& theta_i_deg,
                                                     const std::vector<std::string>& materials);

}  // namespace lrcs
