#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/facet_mesh.h"
#include "view/colour.h"
#include "view/facet_result.h"

namespace lrcs {

inline constexpr Colour unseen_grey{0.83, 0.83, 0.83};  // facets not lit and seen

// What colours are to show of each facet.
enum class FacetQuantity { contribution, seen_fraction, incidence, material, part };
struct FacetShowing {
  FacetQuantity quantity = FacetQuantity::contribution;
  bool per_area = true;     // contribution: over the facet's area; else of the facet
  bool in_decibels = true;  // contribution: below the brightest facet; else linear, from 0 to the brightest
  double darkest = -40.0;   // contribution in decibels below the brightest: this and less look the same
};

// What colours mean. quantity with a scale: viridis from low to high, nothing where these are equal; else names, each
// with its colour.
struct ColourScale {
  std::string title;  // with its unit, and what 0 dB stands for
  double low = 0.0, high = 1.0;
  bool is_open_below = false;  // low stands for less, too
  std::vector<std::pair<std::string, Colour>> names;
  bool has_unseen = true;  // facets not lit and seen are unseen_grey
  bool is_angle = false;   // in degrees
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

// A facet's colour in a picture. Colours of a scale stay as they are, to be found on it; where they are names, and on
// facets that are unseen_grey, they are darker the less a facet faces the viewer, for the shape to be read.
// cos_view: of the angle between normal and viewer.
[[nodiscard]] Rgb drawn_colour(const Colour& colour, bool is_named, double cos_view);

}  // namespace lrcs
