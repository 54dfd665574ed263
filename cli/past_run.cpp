#include "cli/past_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/digest.h"
#include "lrcs/sweep_csv.h"
#include "mesh/file_content.h"

namespace lrcs {
namespace {

constexpr const char* not_ours = "expected the manifest of a sweep by this version; run the sweep again";

nlohmann::json manifest_of(const std::filesystem::path& file, const std::string& content) {
  try {
    return nlohmann::json::parse(content);
  } catch (const nlohmann::json::exception& wrong) {
    throw InputError(Place{file.string()}, "expected the manifest of a sweep in JSON; run the sweep again");
  }
}

void require_same(const std::filesystem::path& file, const std::string& before, const std::string& now) {
  if (before == now) return;
  throw InputError(Place{file.string()},
                   fmt::format("has changed since the sweep (SHA-256 {}, was {}); run the sweep again", now, before));
}

void require_same_inputs(const nlohmann::json& manifest, const Scene& scene, const LoadedTarget& loaded) {
  const nlohmann::json& target = manifest.at("target");
  require_same(scene.target.file, target.at("sha256").get<std::string>(), loaded.digest);
  if (!scene.target.facet_properties.empty())
    require_same(scene.target.facet_properties, target.at("facet_properties").at("sha256").get<std::string>(),
                 loaded.properties_digest);
  const nlohmann::json& materials = manifest.at("materials");
  for (std::size_t k = 0; k < scene.materials.size(); ++k)
    if (const auto* tabulated = std::get_if<Tabulated>(&scene.materials[k].brdf))
      require_same(tabulated->file().path, materials.at(k).at("measurement").at("sha256").get<std::string>(),
                   tabulated->file().digest);
}

// What is read of a result must be what the sweep wrote.
void require_same_outputs(const std::filesystem::path& manifest_file, const nlohmann::json& manifest,
                          const std::filesystem::path& folder) try {
  for (const char* name : {"sweep.csv", scene_as_run}) {
    const auto& outputs = manifest.at("outputs");
    const auto told = std::find_if(outputs.begin(), outputs.end(), [&](const auto& o) { return o.at("file") == name; });
    if (told == outputs.end())
      throw InputError(Place{manifest_file.string()}, fmt::format("knows of no {}; run the sweep again", name));
    require_same(folder / name, told->at("sha256").template get<std::string>(), digest_of_file(folder / name));
  }
} catch (const nlohmann::json::exception&) {
  throw InputError(Place{manifest_file.string()}, not_ours);
}

}  // namespace

PastRun read_past_run(const std::filesystem::path& folder) {
  const auto manifest_file = folder / "manifest.json";
  if (!std::filesystem::exists(manifest_file))
    throw InputError(Place{folder.string()},
                     "holds no manifest.json: expected a folder that lrcs sweep wrote to its end");
  PastRun run;
  run.manifest = plain_content(manifest_file);
  const nlohmann::json manifest = manifest_of(manifest_file, run.manifest);
  run.csv = plain_content(folder / "sweep.csv");
  require_same_outputs(manifest_file, manifest, folder);
  run.rows = read_sweep_csv(folder / "sweep.csv");
  run.scene = read_scene(folder / scene_as_run);
  if (run.scene.directions.size() != run.rows.size())
    throw InputError(Place{(folder / "sweep.csv").string()},
                     fmt::format("expected {} rows, as {} has directions, found {}", run.scene.directions.size(),
                                 scene_as_run, run.rows.size()));
  run.loaded = load_target(run.scene);
  try {
    require_same_inputs(manifest, run.scene, run.loaded);
  } catch (const nlohmann::json::exception&) {
    throw InputError(Place{manifest_file.string()}, not_ours);
  }
  // As they were computed: the file's angles of a bistatic receiver are rounded.
  const std::vector<Aspect> aspects = aspects_of(run.scene.directions, run.scene.receiver);
  for (std::size_t k = 0; k < run.rows.size(); ++k) run.rows[k].aspect = aspects[k];
  return run;
}

bool is_as_before(const PastRun& run, std::size_t row, const Estimate& sigma) {
  constexpr double rounding = 1e-12;  // of sigma
  const Estimate& before = run.rows[row].sigma;
  return run.scene.relative_accuracy ||
         std::abs(sigma.value - before.value) <= before.bound + sigma.bound + rounding * before.value;
}

}  // namespace lrcs
