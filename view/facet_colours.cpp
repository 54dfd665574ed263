#include "view/facet_colours.h"

#include <algorithm>
#include <cmath>

namespace lrcs {

std::vector<double> decibels_below_brightest(const FacetMesh& mesh, const FacetResult& result) {
  std::vector<double> density;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    density.push_back(mesh.areas[i] > 0.0 ? result.sigma_m2[i] / mesh.areas[i] : 0.0);
  }
  const double brightest = density.empty() ? 0.0 : *std::max_element(density.begin(), density.end());
  for (double& d : density) d = 10.0 * std::log10(brightest > 0.0 ? d / brightest : 0.0);
  return density;
}

std::vector<Colour> facet_colours(const FacetMesh& mesh, const FacetResult& result) {
  std::vector<Colour> colours;
  const std::vector<double> decibels = decibels_below_brightest(mesh, result);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const bool unseen = result.seen_fraction[i] <= 0.0;
    const double height = 1.0 - std::max(decibels[i], darkest_db) / darkest_db;
    colours.push_back(unseen ? unseen_grey : viridis(height));
  }
  return colours;
}

}  // namespace lrcs
