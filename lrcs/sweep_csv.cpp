#include "lrcs/sweep_csv.h"

#include <fmt/format.h>

#include <cmath>

#include "base/length.h"
#include "base/version.h"
#include "brdf/material_yaml.h"

namespace lrcs {
namespace {

// A mapping of one key a line, on one line.
std::string on_one_line(const std::string& mapping) {
  std::string line;
  for (const char c : mapping) line += c == '\n' ? std::string(", ") : std::string(1, c);
  while (line.ends_with(", ")) line.resize(line.size() - 2);
  return line;
}

std::string comments(const Scene& scene, const std::string& target_digest) {
  std::string text = fmt::format("# lrcs {}: laser radar cross section\n", version);
  text += fmt::format("# scene sha256: {}\n# target sha256: {}\n", scene.digest, target_digest);
  text +=
      fmt::format("# wavelength: {}\n", scene.wavelength > 0.0 ? text_of_length(scene.wavelength, "um") : "not stated");
  for (const Material& m : scene.materials)
    text += fmt::format("# material {}: {}\n", m.name, on_one_line(material_to_yaml(m)));
  text +=
      "# azimuth from +x (forward) toward +y (left), elevation from the xy-plane toward +z (up), in the body frame\n";
  text += "# sigma = 4 pi Integral f_r cos_i cos_r dA over what is lit and seen; dBsm = 10 log10(sigma / 1 m^2)\n";
  text += "# |sigma - true sigma of the facets| <= bound; seen area: lit and seen, projected toward the receiver\n";
  return text;
}

}  // namespace

double dbsm(double sigma_m2) {
  return 10.0 * std::log10(sigma_m2);
}

std::string sweep_csv(const Scene& scene, const std::string& target_digest, const std::vector<SweepRow>& rows) {
  std::string text = comments(scene, target_digest);
  text +=
      "transmitter_azimuth_deg,transmitter_elevation_deg,receiver_azimuth_deg,receiver_elevation_deg,sigma_m2,sigma_"
      "dbsm,"
      "bound_m2,seen_area_m2\n";
  for (const SweepRow& row : rows) {
    const auto& [transmitter, receiver, di, dr] = row.aspect;
    text += fmt::format("{},{},{},{},{},{},{},{}\n", transmitter.azimuth_deg, transmitter.elevation_deg,
                        receiver.azimuth_deg, receiver.elevation_deg, row.sigma.value, dbsm(row.sigma.value),
                        row.sigma.bound, row.seen_area);
  }
  return text;
}

}  // namespace lrcs
