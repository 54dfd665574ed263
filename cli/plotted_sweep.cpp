#include "cli/plotted_sweep.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/input_error.h"
#include "lrcs/sweep_csv.h"
#include "mesh/file_content.h"

namespace lrcs {
namespace {

namespace fs = std::filesystem;

constexpr const char* table_name = "sweep.csv";

// A manifest only names the target in a title: what is wrong with it is no error here.
std::string target_of(const fs::path& folder) {
  const fs::path manifest = folder / "manifest.json";
  if (!fs::exists(manifest)) return "";
  const auto json = nlohmann::json::parse(plain_content(manifest), nullptr, false);
  const auto place = nlohmann::json::json_pointer("/target/file");
  if (json.is_discarded() || !json.contains(place) || !json.at(place).is_string()) return "";
  return fs::path(json.at(place).get<std::string>()).filename().string();
}

// "results/tess/" is "tess", "." the working folder's name.
std::string name_of(const fs::path& folder) {
  const fs::path whole = fs::weakly_canonical(fs::absolute(folder));
  return whole.has_filename() ? whole.filename().string() : whole.parent_path().filename().string();
}

std::string list_of(const Cuts& cuts) {
  constexpr std::size_t most = 12;
  std::vector<std::string> names;
  for (const ViewedCut& cut : cuts.cuts) names.push_back(cut.curve.label);
  const bool all = names.size() <= most;
  if (!all) names.resize(most);
  return fmt::format("{}{}", fmt::join(names, ", "), all ? "" : fmt::format(" and {} more", cuts.cuts.size() - most));
}

// The cut at that value of its fixed angle.
Cuts only_at(const Cuts& all, const PlottedSweep& sweep, double AspectAngles::*fixed, double angle, const char* flag) {
  constexpr double rounding = 1e-9;  // [deg]
  Cuts one{{}, all.axis, all.angle};
  for (const ViewedCut& cut : all.cuts)
    if (std::abs(sweep.rows[cut.rows.front()].aspect.transmitter.*fixed - angle) <= rounding) one.cuts = {cut};
  if (one.cuts.empty())
    throw InputError(fmt::format("{}: {} has no cut at {} deg; it has {}", flag, sweep.input, angle, list_of(all)));
  return one;
}

}  // namespace

bool PlottedSweep::is_monostatic() const {
  return std::all_of(rows.begin(), rows.end(),
                     [](const SweepRow& row) { return row.aspect.transmitter == row.aspect.receiver; });
}

PlottedSweep read_plotted_sweep(const std::string& input) {
  const bool is_folder = fs::is_directory(input);
  const fs::path file = is_folder ? fs::path(input) / table_name : fs::path(input);
  if (!fs::exists(file))
    throw InputError(Place{input}, is_folder ? "holds no sweep.csv: expected a folder that lrcs sweep wrote"
                                             : "no such file: expected a folder that lrcs sweep wrote, or a sweep.csv");
  PlottedSweep sweep{input, file.stem().string(), "", read_sweep_csv(file)};
  if (file.filename() != table_name) return sweep;
  sweep.label = name_of(file.has_parent_path() ? file.parent_path() : fs::path("."));
  sweep.target = target_of(file.parent_path());
  return sweep;
}

void tell_apart(std::vector<PlottedSweep>& sweeps) {
  std::vector<std::string> labels;
  labels.reserve(sweeps.size());
  for (const PlottedSweep& sweep : sweeps) labels.push_back(sweep.label);
  for (PlottedSweep& sweep : sweeps)
    if (std::count(labels.begin(), labels.end(), sweep.label) > 1) sweep.label = sweep.input;
}

Cuts chosen_cuts(const PlottedSweep& sweep, const CutChoice& choice) {
  if (choice.elevation_deg)
    return only_at(azimuth_cuts(sweep.rows), sweep, &AspectAngles::elevation_deg, *choice.elevation_deg, "--elevation");
  if (choice.azimuth_deg)
    return only_at(elevation_cuts(sweep.rows), sweep, &AspectAngles::azimuth_deg, *choice.azimuth_deg, "--azimuth");
  return cuts_of(sweep.rows);
}

void require_one_cut(const PlottedSweep& sweep, const Cuts& cuts) {
  if (cuts.cuts.size() == 1) return;
  throw InputError(Place{sweep.input},
                   fmt::format("has {} cuts ({}), expected one: choose it by --elevation or --azimuth",
                               cuts.cuts.size(), list_of(cuts)));
}

}  // namespace lrcs
