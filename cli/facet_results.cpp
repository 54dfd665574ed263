#include "cli/facet_results.h"

namespace lrcs {

FacetResult facet_result(const Target& target, const SweepRow& row, const CrossSection& section) {
  FacetResult result;
  result.material = target.material;
  for (std::size_t f = 0; f < target.back.size(); ++f)
    if (target.mesh.normals[f].dot(row.aspect.to_receiver) < 0.0) result.material[f] = target.back[f];
  for (const Material& m : target.materials) result.material_names.push_back(m.name);
  result.seen_fraction = section.seen_fraction;
  result.sigma_m2 = section.facet_sigma;
  result.transmitter_azimuth_deg = row.aspect.transmitter.azimuth_deg;
  result.transmitter_elevation_deg = row.aspect.transmitter.elevation_deg;
  result.receiver_azimuth_deg = row.aspect.receiver.azimuth_deg;
  result.receiver_elevation_deg = row.aspect.receiver.elevation_deg;
  result.sigma_total_m2 = row.sigma.value;
  return result;
}

std::string title_of(const Scene& scene) {
  const bool is_monostatic = scene.receiver.kind == Receiver::Kind::monostatic;
  return std::string(is_monostatic ? "Monostatic" : "Bistatic") + " LRCS of " + scene.target.file.filename().string();
}

}  // namespace lrcs
