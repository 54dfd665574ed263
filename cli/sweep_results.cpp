#include "cli/sweep_results.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <system_error>
#include <utility>

#include "base/digest.h"
#include "base/whole_file.h"
#include "cli/facet_results.h"
#include "cli/past_run.h"
#include "cli/sweep_cuts.h"
#include "cli/sweep_map.h"
#include "lrcs/scene_yaml.h"
#include "lrcs/sweep_csv.h"
#include "view/facets_picture.h"
#include "view/facets_vtp.h"
#include "view/map_plot.h"
#include "view/sweep_plot.h"

namespace lrcs {
namespace {

constexpr const char* hdf5_name = "sweep.h5";
constexpr const char* series_name = "facets.pvd";
// Where pictures of facets wait until the sweep is done: they are drawn from the main thread only.
constexpr std::size_t picture_memory = std::size_t{256} << 20U;  // [bytes]

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed || !std::filesystem::is_directory(folder))
    throw InputError(Place{folder.string()}, fmt::format("cannot be made a folder for the results: {}",
                                                         failed ? failed.message() : "it is a file"));
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError(Place{folder.string()},
                     fmt::format("results cannot be written to this folder: {}", std::strerror(errno)));
}

}  // namespace

SweepResults::SweepResults(std::filesystem::path folder, const Scene& scene, const LoadedTarget& loaded, bool with_hdf5)
    : folder_(std::move(folder)), scene_(scene), loaded_(loaded), files_of_row_(scene.directions.size()) {
  const auto rows = facet_rows(scene);
  for (std::size_t k = 0; k < rows.size(); ++k) files_of_row_[rows[k]].push_back(k);
  if (scene.facets.all)
    for (std::size_t k = 0; k < files_of_row_.size(); ++k) files_of_row_[k] = {k};
  make_folder(folder_);
  // The manifest first: without it nothing counts. What this run may not write must not be taken for its own.
  for (const char* name : {"manifest.json", hdf5_name, series_name, "report.html"}) {
    std::error_code failed;
    std::filesystem::remove(folder_ / name, failed);
    if (failed) throw InputError(Place{(folder_ / name).string()}, fmt::format("is in the way: {}", failed.message()));
  }
  if (!with_hdf5) return;
  std::vector<std::size_t> with_facets;
  for (std::size_t row = 0; row < files_of_row_.size(); ++row)
    if (wants_facets(row)) with_facets.push_back(row);
  hdf5_.emplace(folder_ / hdf5_name, scene_, loaded_, std::move(with_facets));
}

void SweepResults::keep(const std::string& name) {
  outputs_.emplace_back(name, digest_of_file(folder_ / name));
}

std::size_t SweepResults::most_pictures() const {
  const std::size_t one = 2 * sizeof(double) * std::max<std::size_t>(1, loaded_.target.mesh.size());
  return std::max<std::size_t>(1, picture_memory / one);
}

void SweepResults::write_facets(std::size_t row, const SweepRow& result, const CrossSection& section) {
  if (hdf5_) hdf5_->write_facets(row, section);
  for (const std::size_t k : files_of_row_[row]) {
    const std::string name = fmt::format("facets-{}.vtp", k);
    write_facets_vtp(folder_ / name, loaded_.target.mesh, facet_result(loaded_.target, result, section));
    keep(name);
    facets_.push_back({k, row, name, result.aspect});
    if (!scene_.facets.all && k < most_pictures()) pictures_.push_back({k, result.aspect, section});
  }
}

void SweepResults::write_table(const std::vector<SweepRow>& rows) {
  write_whole_file(folder_ / "sweep.csv", sweep_csv(scene_, loaded_.digest, rows));
  keep("sweep.csv");
  write_whole_file(folder_ / scene_as_run, scene_to_yaml(scene_, folder_));
  keep(scene_as_run);
  write_series();
  if (!hdf5_) return;
  hdf5_->finish(rows);
  keep(hdf5_name);
}

// ParaView's time is the row of the sweep.
void SweepResults::write_series() {
  if (facets_.empty()) return;
  std::map<std::size_t, std::string> file_of_row;
  for (const FacetFile& file : facets_) file_of_row.emplace(file.row, file.name);
  std::string pvd = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (const auto& [row, name] : file_of_row)
    pvd += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", row, name);
  write_whole_file(folder_ / series_name, pvd + "  </Collection>\n</VTKFile>\n");
  keep(series_name);
}

void SweepResults::attempt(const std::string& name,
                           const std::function<void(const std::filesystem::path& png)>& drawing,
                           std::vector<std::string>& warnings) {
  try {
    drawing(folder_ / name);
    keep(name);
  } catch (const std::exception& impossible) {
    warnings.push_back(fmt::format("{} was not drawn: {}", name, impossible.what()));
  }
}

void SweepResults::draw(const std::vector<SweepRow>& rows, std::vector<std::string>& warnings) {
  const Cuts cuts = cuts_of(rows);
  std::size_t left_out = 0;
  const std::vector<Curve> curves = cuts.curves(most_curves, &left_out);
  const PlotText text{title_of(scene_), cuts.axis, cuts.angle};
  if (left_out > 0)
    warnings.push_back(fmt::format("the plots show the first {} cuts, {} are left out", most_curves, left_out));
  attempt(
      "sweep.png", [&](const auto& png) { draw_sweep_plot(png, curves, text); }, warnings);
  attempt(
      "polar.png", [&](const auto& png) { draw_polar_plot(png, curves, text); }, warnings);
  if (const auto map = direction_map(rows))
    attempt(
        "map.png", [&](const auto& png) { draw_map_plot(png, *map, {text.title}); }, warnings);
  if (scene_.facets.directions.size() > most_pictures())
    warnings.push_back(
        fmt::format("pictures are drawn of the first {} facet files only, to save memory", most_pictures()));
  std::sort(pictures_.begin(), pictures_.end(), [](const auto& a, const auto& b) { return a.k < b.k; });
  for (const FacetPicture& picture : pictures_) {
    const SweepRow row{picture.aspect, picture.section.sigma, picture.section.seen_area};
    const FacetResult result = facet_result(loaded_.target, row, picture.section);
    attempt(
        fmt::format("facets-{}.png", picture.k),
        [&](const auto& png) {
          draw_facets_picture(png, loaded_.target.mesh, result, picture.aspect.to_receiver, Vec3::UnitZ(), 1600, 1200);
        },
        warnings);
  }
}

void SweepResults::write_manifest(RunFacts facts) {
  std::sort(outputs_.begin(), outputs_.end());
  std::sort(facets_.begin(), facets_.end(), [](const FacetFile& a, const FacetFile& b) { return a.k < b.k; });
  facts.outputs = outputs_;
  facts.facets = facets_;
  write_whole_file(folder_ / "manifest.json", manifest_json(scene_, loaded_, facts));
}

}  // namespace lrcs
