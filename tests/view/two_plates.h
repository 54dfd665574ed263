#pragma once
#include "mesh/facet_mesh.h"
#include "view/facet_result.h"

namespace lrcs {

// Two unit squares in the yz-plane, of two facets each, side by side along y; seen from +x. The left one returns 20 dB
// less per area; the second facet of the right one is not seen.
struct TwoPlates {
  FacetMesh mesh;
  FacetResult result;
};

inline TwoPlates two_plates() {
  TwoPlates plates;
  FacetMesh& mesh = plates.mesh;
  mesh.positions = {{0.1, 0.0, 0.0}, {0.1, 1.0, 0.0}, {0.1, 1.0, 1.0}, {0.1, 0.0, 1.0},
                    {0.1, 1.1, 0.0}, {0.1, 2.1, 0.0}, {0.1, 2.1, 1.0}, {0.1, 1.1, 1.0}};
  mesh.facets = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  mesh.part.of = {0, 0, 1, 1};
  mesh.part.names = {"right", "left, \"quoted\" & <odd>"};
  mesh.source_facet = {0, 0, 1, 1};
  mesh.file_material.of = {0, 0, 0, 0};
  mesh.file_material.names = {""};
  mesh.normals.assign(4, Vec3::UnitX());
  mesh.areas.assign(4, 0.5);
  plates.result.material = {1, 1, 0, 0};
  plates.result.material_names = {"skin", "paint"};
  plates.result.seen_fraction = {1.0, 0.0, 1.0 / 3.0, 1.0};
  plates.result.sigma_m2 = {1.0, 0.0, 0.01, 0.01 / 3.0};
  plates.result.receiver_azimuth_deg = 0.1;
  plates.result.transmitter_azimuth_deg = 0.1;
  plates.result.sigma_total_m2 = 1.01 + 0.01 / 3.0;
  return plates;
}

}  // namespace lrcs
