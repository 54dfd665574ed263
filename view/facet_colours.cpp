#include "view/facet_colours.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/direction.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

// Colours of a quantity that is known where a facet is lit and seen.
std::vector<Colour> along_scale(const std::vector<double>& values, const FacetResult& result,
                                const ColourScale& scale) {
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double height = scale.high > scale.low ? (values[i] - scale.low) / (scale.high - scale.low) : 0.0;
    const bool is_seen = result.seen_fraction[i] > 0.0;
    colours.push_back(is_seen ? viridis(std::clamp(height, 0.0, 1.0)) : unseen_grey);
  }
  return colours;
}

ColouredFacets by_contribution(const FacetMesh& mesh, const FacetResult& result, const FacetShowing& showing) {
  std::vector<double> values = result.sigma_m2;
  for (std::size_t i = 0; showing.per_area && i < values.size(); ++i)
    values[i] = mesh.areas[i] > 0.0 ? values[i] / mesh.areas[i] : 0.0;
  const double brightest = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  const std::string what = showing.per_area ? "return per area" : "return per facet";
  const std::string unit = showing.per_area ? "m²/m²" : "m²";
  ColouredFacets coloured;
  if (!(brightest > 0.0)) {
    coloured.scale = {"no return", 0.0, 0.0, false, {}, true};
  } else if (showing.in_decibels) {
    const std::string reference = " [dB re " + number_label(brightest, 3) + " " + unit + "]";
    coloured.scale = {what + reference, showing.darkest, 0.0, true, {}, true};
    for (double& value : values) value = 10.0 * std::log10(value / brightest);
  } else {
    coloured.scale = {what + " [" + unit + "]", 0.0, brightest, false, {}, true};
  }
  coloured.colours = along_scale(values, result, coloured.scale);
  return coloured;
}

ColouredFacets by_incidence(const FacetMesh& mesh, const FacetResult& result) {
  const Vec3 di = direction_of({result.transmitter_azimuth_deg, result.transmitter_elevation_deg});
  std::vector<double> angles;
  for (const Vec3& n : mesh.normals) angles.push_back(std::acos(std::min(1.0, std::abs(n.dot(di)))) / degree);
  ColouredFacets coloured;
  coloured.scale = {"angle of incidence [deg]", 0.0, 90.0, false, {}, true, true};
  coloured.colours = along_scale(angles, result, coloured.scale);
  return coloured;
}

// of: one a facet, an index into names.
ColouredFacets by_name(const std::string& title, const FacetMesh& mesh, const std::vector<std::uint32_t>& of,
                       const std::vector<std::string>& names) {
  constexpr std::size_t told_apart = 7;
  constexpr Colour other{0.6, 0.6, 0.6};
  std::vector<double> area(names.size(), 0.0);
  for (std::size_t i = 0; i < of.size(); ++i) area[of[i]] += mesh.areas[i];
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return area[a] > area[b]; });
  std::vector<Colour> colour_of(names.size(), other);
  ColouredFacets coloured;
  coloured.scale = {title, 0.0, 1.0, false, {}, false};
  for (std::size_t k = 0; k < std::min(told_apart, order.size()); ++k) {
    colour_of[order[k]] = curve_colour(k);
    coloured.scale.names.emplace_back(names[order[k]], curve_colour(k));
  }
  if (order.size() > told_apart) coloured.scale.names.emplace_back("others", other);
  for (const std::uint32_t k : of) coloured.colours.push_back(colour_of[k]);
  return coloured;
}

}  // namespace

ColouredFacets coloured_facets(const FacetMesh& mesh, const FacetResult& result, const FacetShowing& showing) {
  switch (showing.quantity) {
    case FacetQuantity::seen_fraction: {
      ColouredFacets coloured;
      coloured.scale = {"seen fraction of facet", 0.0, 1.0, false, {}, true};
      coloured.colours = along_scale(result.seen_fraction, result, coloured.scale);
      return coloured;
    }
    case FacetQuantity::incidence:
      return by_incidence(mesh, result);
    case FacetQuantity::material:
      return by_name("material", mesh, result.material, result.material_names);
    case FacetQuantity::part:
      return by_name("part", mesh, mesh.part.of, mesh.part.names);
    default:
      return by_contribution(mesh, result, showing);
  }
}

Rgb drawn_colour(const Colour& colour, bool is_named, double cos_view) {
  constexpr double edge_on = 0.75;  // brightness; 1 face on
  const bool is_shaded = is_named || rgb_of(colour) == rgb_of(unseen_grey);
  const double light = is_shaded ? std::lerp(edge_on, 1.0, std::abs(cos_view)) : 1.0;
  return rgb_of({light * colour.red, light * colour.green, light * colour.blue});
}

}  // namespace lrcs
