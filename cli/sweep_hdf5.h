#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "lrcs/scene_target.h"
#include "lrcs/sweep.h"

namespace lrcs {

// A sweep as an HDF5 file with dimension scales and units, as netCDF-4 has them: xarray opens it as a labelled dataset.
// Dimensions: elevation and azimuth of the transmitter where the rows are all their pairs, each once, azimuth fastest,
// else row. Along them: sigma, bound, seen_area; receiver_azimuth, receiver_elevation; of rows also transmitter_azimuth
// and transmitter_elevation. Where facets were asked for: facet_row (rows of the sweep) and facet, along which
// facet_sigma and seen_fraction; part, material, material_back and source_facet along facet; part_name, material_name.
// Held in memory until it is complete.
// units: degree, m2, 1. laws: numbers are the same doubles as in sweep.csv and the facet files;
// the same input gives the same bytes.
class SweepHdf5 {
 public:
  // file: appears when it is complete. facet_rows: rising. error: InputError where the facets would take more than 4
  // GB.
  SweepHdf5(std::filesystem::path file, const Scene& scene, const LoadedTarget& loaded,
            std::vector<std::size_t> facet_rows);
  ~SweepHdf5();
  SweepHdf5(const SweepHdf5&) = delete;
  SweepHdf5& operator=(const SweepHdf5&) = delete;

  // One of the rows; in any order, one at a time. error of all: std::runtime_error that names the file.
  void write_facets(std::size_t row, const CrossSection& section);
  void finish(const std::vector<SweepRow>& rows);

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
};

}  // namespace lrcs
