#include "cli/sweep_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "base/digest.h"
#include "base/whole_file.h"
#include "cli/sweep_cuts.h"
#include "lrcs/sweep_csv.h"
#include "view/facets_picture.h"
#include "view/facets_vtp.h"
#include "view/sweep_plot.h"

namespace lrcs {
namespace {

// Rows of the sweep whose transmitter direction is the asked one; the first of them counts.
std::size_t row_of(const AspectAngles& asked, const Place& place, const std::vector<AspectAngles>& directions) {
  // Angles that print the same to a user are the same: from + k step need not hit the double nearest to the decimals.
  constexpr double same_deg = 1.0 / 1048576.0;
  const Vec3 d = direction_of(asked);
  double nearest = 4.0;
  std::size_t row = 0;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double apart = (direction_of(directions[k]) - d).norm();
    if (apart < nearest) {
      nearest = apart;
      row = k;
    }
  }
  if (nearest > same_deg * degree)
    throw InputError(place,
                     fmt::format("the direction azimuth {}, elevation {} is not in the sweep; the nearest is {}, {}",
                                 asked.azimuth_deg, asked.elevation_deg, directions[row].azimuth_deg,
                                 directions[row].elevation_deg));
  return row;
}

FacetResult facet_result(const Target& target, const SweepRow& row, const CrossSection& section) {
  FacetResult result;
  result.material = target.material;
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

}  // namespace

SweepResults::SweepResults(std::filesystem::path folder, const Scene& scene, const LoadedTarget& loaded)
    : folder_(std::move(folder)), scene_(scene), loaded_(loaded), files_of_row_(scene.directions.size()) {
  for (std::size_t k = 0; k < scene.facets.directions.size(); ++k)
    files_of_row_[row_of(scene.facets.directions[k], scene.facets.places[k], scene.directions)].push_back(k);
  if (scene.facets.all)
    for (std::size_t k = 0; k < files_of_row_.size(); ++k) files_of_row_[k] = {k};
  std::error_code failed;
  std::filesystem::create_directories(folder_, failed);
  if (failed) throw InputError(Place{folder_.string()}, fmt::format("cannot be made a folder: {}", failed.message()));
  std::filesystem::remove(folder_ / "manifest.json", failed);
}

void SweepResults::keep(const std::string& name) {
  outputs_.emplace_back(name, digest_of_file(folder_ / name));
}

void SweepResults::write_facets(std::size_t row, const SweepRow& result, const CrossSection& section) {
  for (const std::size_t k : files_of_row_[row]) {
    const std::string name = fmt::format("facets-{}.vtp", k);
    write_facets_vtp(folder_ / name, loaded_.target.mesh, facet_result(loaded_.target, result, section));
    keep(name);
    if (!scene_.facets.all) pictures_.push_back({folder_ / fmt::format("facets-{}.png", k), result.aspect, section});
  }
}

void SweepResults::write_table(const std::vector<SweepRow>& rows) {
  write_whole_file(folder_ / "sweep.csv", sweep_csv(scene_, loaded_.digest, rows));
  keep("sweep.csv");
}

void SweepResults::draw(const std::vector<SweepRow>& rows, std::vector<std::string>& warnings) {
  const auto attempt = [&](const std::string& name, const auto& drawing) {
    try {
      drawing(folder_ / name);
      keep(name);
    } catch (const std::exception& impossible) {
      warnings.push_back(fmt::format("{} was not drawn: {}", name, impossible.what()));
    }
  };
  const Cuts cuts = cuts_of(rows);
  const std::string what = scene_.receiver.kind == Receiver::Kind::monostatic ? "Monostatic LRCS" : "Bistatic LRCS";
  const PlotText text{fmt::format("{} of {}", what, scene_.target.file.filename().string()), cuts.axis, cuts.angle};
  if (cuts.left_out > 0)
    warnings.push_back(fmt::format("the plots show the first {} cuts, {} are left out", most_curves, cuts.left_out));
  attempt("sweep.png", [&](const auto& png) { draw_sweep_plot(png, cuts.curves, text); });
  attempt("polar.png", [&](const auto& png) { draw_polar_plot(png, cuts.curves, text); });
  std::sort(pictures_.begin(), pictures_.end(), [](const auto& a, const auto& b) { return a.png < b.png; });
  for (const FacetPicture& picture : pictures_)
    attempt(picture.png.filename().string(), [&](const auto& png) {
      const SweepRow row{picture.aspect, picture.section.sigma, picture.section.seen_area};
      draw_facets_picture(png, loaded_.target.mesh, facet_result(loaded_.target, row, picture.section),
                          picture.aspect.to_receiver, Vec3::UnitZ(), 1600, 1200);
    });
}

void SweepResults::write_manifest(RunFacts facts) {
  std::sort(outputs_.begin(), outputs_.end());
  facts.outputs = outputs_;
  write_whole_file(folder_ / "manifest.json", manifest_json(scene_, loaded_, facts));
}

}  // namespace lrcs
