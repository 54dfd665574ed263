#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "lrcs/manifest.h"
#include "lrcs/scene_target.h"
#include "lrcs/sweep.h"

namespace lrcs {

// Writes the results of a sweep into a folder, each file whole or not at all, and keeps the list for the manifest.
class SweepResults {
 public:
  // Makes the folder. An earlier run's manifest is taken away first: a folder with a manifest is a complete result.
  SweepResults(std::filesystem::path folder, const Scene& scene, const LoadedTarget& loaded);

  // The rows for which the scene asks facet files. An asked direction outside the sweep: InputError.
  [[nodiscard]] bool wants_facets(std::size_t row) const { return !files_of_row_[row].empty(); }
  void write_facets(std::size_t row, const SweepRow& result, const CrossSection& section);

  void write_table(const std::vector<SweepRow>& rows);
  // sweep.png and polar.png, and a picture of each facet file asked by direction. What cannot be drawn is a warning.
  void draw(const std::vector<SweepRow>& rows, std::vector<std::string>& warnings);
  void write_manifest(RunFacts facts);

 private:
  struct FacetPicture {
    std::filesystem::path png;
    Aspect aspect;
    CrossSection section;
  };
  void keep(const std::string& name);

  std::filesystem::path folder_;
  const Scene& scene_;
  const LoadedTarget& loaded_;
  std::vector<std::vector<std::size_t>> files_of_row_;  // numbers k of facets-k.vtp
  std::vector<FacetPicture> pictures_;
  std::vector<std::pair<std::string, std::string>> outputs_;
};

}  // namespace lrcs
