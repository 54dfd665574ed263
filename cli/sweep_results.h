#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/sweep_hdf5.h"
#include "lrcs/manifest.h"
#include "lrcs/scene_target.h"
#include "lrcs/sweep.h"

namespace lrcs {

// Writes the results of a sweep into a folder, each file whole or not at all, and keeps the list for the manifest.
class SweepResults {
 public:
  // Makes the folder, when everything asked is known to be in the sweep. An earlier run's manifest is taken away first:
  // a folder with a manifest is a complete result. InputError: a direction outside the sweep; a folder that cannot be
  // written to.
  // with_hdf5: sweep.h5, too.
  SweepResults(std::filesystem::path folder, const Scene& scene, const LoadedTarget& loaded, bool with_hdf5 = false);

  // The rows for which the scene asks facet files.
  [[nodiscard]] bool wants_facets(std::size_t row) const { return !files_of_row_[row].empty(); }
  void write_facets(std::size_t row, const SweepRow& result, const CrossSection& section);

  // sweep.csv, the scene as it was run, the series of the facet files, sweep.h5.
  void write_table(const std::vector<SweepRow>& rows);
  // sweep.png and polar.png, map.png of a grid of both angles, and a picture of each facet file asked by direction, as
  // many as memory is set aside for. What cannot be drawn is a warning.
  void draw(const std::vector<SweepRow>& rows, std::vector<std::string>& warnings);
  void write_manifest(RunFacts facts);

 private:
  struct FacetPicture {
    std::size_t k;
    Aspect aspect;
    CrossSection section;
  };
  void keep(const std::string& name);
  void write_series();
  void attempt(const std::string& name, const std::function<void(const std::filesystem::path& png)>& drawing,
               std::vector<std::string>& warnings);
  [[nodiscard]] std::size_t most_pictures() const;

  std::filesystem::path folder_;
  const Scene& scene_;
  const LoadedTarget& loaded_;
  std::vector<std::vector<std::size_t>> files_of_row_;  // numbers k of facets-k.vtp
  std::vector<FacetPicture> pictures_;
  std::optional<SweepHdf5> hdf5_;
  std::vector<std::pair<std::string, std::string>> outputs_;
  std::vector<FacetFile> facets_;
};

}  // namespace lrcs
