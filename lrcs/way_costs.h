#pragma once
#include <algorithm>
#include <cmath>

namespace lrcs {

// What a row takes in each of the ways, in seconds on one core of 2020: only ratios count. Formulas of counts, fitted
// to targets of 7,000 to 2,000,000 facets (docs/performance.md): so a choice does not depend on load or threads.
// facets: of the target; size: a grid of about size x size places.

// Past the caches everything takes longer.
inline double memory_factor(double facets) {
  return std::pow(std::max(1.0, facets / 1e5), 0.35);
}

// depth: how often fronts cover what is seen, on the average, 1 or more. The deeper, the more facets lie under
// outlines. At a given depth targets differ by up to three.
inline double exact_cost(double facets, double depth) {
  const double under_outlines = std::min(1.0, (depth - 1.0) / 0.7);
  return 0.2e-6 * facets + 200e-6 * std::sqrt(facets) * under_outlines * under_outlines;
}

// RowDrawing: facets that meet no row are passed over.
inline double drawing_cost(double facets, double size) {
  const double met = std::min(1.0, size / std::sqrt(facets));
  return facets * (10e-9 + 40e-9 * met) * memory_factor(facets) + 4.5e-9 * size * size;
}

// RowRays, one direction: rays that meet another facet than their neighbours go other ways in the tree.
// variety: how often a place of a coarse grid shows another facet than the one before, 0 to 1.
inline double rays_cost(double facets, double size, double variety) {
  return (15e-9 * size * size + 60e-9 * variety * size * std::sqrt(facets)) * memory_factor(facets);
}

// UnmetReturns, of two directions; of one it is hardly noticed.
inline double unmet_cost(double facets) {
  return 40e-9 * facets;
}

}  // namespace lrcs
