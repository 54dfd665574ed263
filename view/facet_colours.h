#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/facet_mesh.h"
#include "view/colour.h"
#include "view/facet_result.h"

namespace lrcs {

inline constexpr double darkest_db = -40.0;             // below the brightest facet, still told apart [dB]
inline constexpr Colour unseen_grey{0.83, 0.83, 0.83};  // facets not lit and seen

// sigma / area of each facet in dB below the largest: <= 0; minus infinity where sigma or area is 0.
[[nodiscard]] std::vector<double> decibels_below_brightest(const FacetMesh& mesh, const FacetResult& result);

// The colour of each facet, by the value above; darkest_db and less look the same.
[[nodiscard]] std::vector<Colour> facet_colours(const FacetMesh& mesh, const FacetResult& result);

// What colours are to show of each facet.
enum class FacetQuantity { contribution, seen_fraction, incidence, material, part };
struct FacetShowing {
  FacetQuantity quantity = FacetQuantity::contribution;
  bool per_area = true;         // contribution: over the facet's area; else of the facet
  bool in_decibels = true;      // contribution: below the brightest facet; else linear, from 0 to the brightest
  double darkest = darkest_db;  // contribution in decibels: this and less look the same
};

// What colours mean. quantity with a scale: viridis from low to high; else names, each with its colour.
struct ColourScale {
  std::string title;  // with its unit
  std::string note;   // "0 dB: 3.21 m²/m²"; or ""
  double low = 0.0, high = 1.0;
  bool is_open_below = false;  // low stands for less, too
  std::vector<std::pair<std::string, Colour>> names;
  bool has_unseen = true;  // facets not lit and seen are unseen_grey
};

struct ColouredFacets {
  std::vector<Colour> colours;  // one a facet
  ColourScale scale;
};

// value: contribution: sigma_m2 [m^2], or over the area [m^2/m^2], or dB below the brightest facet of this direction;
//   incidence: angle between the facet's normal, of the side toward the receiver, and the transmitter [deg]; material
//   and part: the first of them seven colours by their area, the rest one grey, seen or not.
[[nodiscard]] ColouredFacets coloured_facets(const FacetMesh& mesh, const FacetResult& result,
                                             const FacetShowing& showing);

}  // namespace lrcs
