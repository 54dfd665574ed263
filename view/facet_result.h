#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace lrcs {

// What each facet does in one direction of a sweep, for files and pictures.
// shape: material, seen_fraction, sigma_m2: one entry a facet.
// domain: material below material_names.size(); seen_fraction in [0, 1]: lit and seen, of the facet's area;
//   sigma_m2 finite and >= 0 [m^2], the facet's share of sigma_total_m2.
// frame: angles of d(az, el) in the body frame [deg].
struct FacetResult {
  std::vector<std::uint32_t> material;
  std::vector<std::string> material_names;
  std::vector<double> seen_fraction;
  std::vector<double> sigma_m2;
  double transmitter_azimuth_deg = 0.0;
  double transmitter_elevation_deg = 0.0;
  double receiver_azimuth_deg = 0.0;
  double receiver_elevation_deg = 0.0;
  double sigma_total_m2 = 0.0;
};

}  // namespace lrcs
