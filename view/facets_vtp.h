#pragma once
#include <filesystem>

#include "mesh/facet_mesh.h"
#include "view/facet_result.h"

namespace lrcs {

// Writes a direction's facets as VTK XML PolyData, to be opened in ParaView. Needs no display.
// value: points as doubles [m]; cell arrays `part`, `material` (numbers into the field data's string arrays
//   `part_names`, `material_names`), `source_facet`, `seen_fraction`, `sigma_m2`; field data
//   `transmitter_azimuth_deg`, `transmitter_elevation_deg`, `receiver_azimuth_deg`, `receiver_elevation_deg`,
//   `sigma_total_m2`. Numbers with a unit have it as the array's UNITS_LABEL, too: m2, degree, 1. Binary, exact.
// shape: one triangle a facet, in their order.
// laws: the same input gives the same bytes.
// domain: as FacetResult; arrays of another length than the mesh has facets: std::invalid_argument.
// error: std::runtime_error where the file cannot be written; it appears whole or not at all.
// check: tests/view/facets_vtp_test.cpp reads it back.
void write_facets_vtp(const std::filesystem::path& vtp, const FacetMesh& mesh, const FacetResult& result);

// Writes a target as VTK XML PolyData, in the mesh's own unit.
// value: points as doubles; cell arrays `part` (with `part_names`, as above), `source_facet`, and as words, where the
//   mesh has them, `file_material`, `colour`, `layer` and the facet properties by their names.
// laws, error: as above; facets are in their order.
void write_mesh_vtp(const std::filesystem::path& vtp, const FacetMesh& mesh);

}  // namespace lrcs
