#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "lrcs/scene_target.h"

namespace lrcs {
namespace {

void check(const std::string& file, bool quiet) {
  const Scene scene = read_scene(file);
  (void)facet_rows(scene);
  const LoadedTarget loaded = load_target(scene);
  fmt::print("{}: ok\n", file);
  fmt::print("target      {}: {} facets in {} parts\n", scene.target.file.string(), loaded.target.mesh.size(),
             loaded.target.mesh.part.names.size());
  const auto count = [](const std::vector<std::uint32_t>& materials, std::uint32_t m) {
    return std::count(materials.begin(), materials.end(), m);
  };
  const Target& target = loaded.target;
  for (std::uint32_t m = 0; m < scene.materials.size(); ++m)
    fmt::print("material    {}: {} facets{}\n", scene.materials[m].name, count(target.material, m),
               target.back.empty() ? "" : fmt::format(", {} from behind", count(target.back, m)));
  fmt::print("directions  {}\n", scene.directions.size());
  if (quiet) return;
  for (const auto& warnings : {material_warnings(scene), loaded.warnings})
    for (const auto& warning : warnings) fmt::print(stderr, "lrcs: warning: {}\n", warning);
}

}  // namespace

void add_check_command(CLI::App& app, Common& common) {
  const auto file = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("check", "Read and resolve a scene, compute nothing");
  verb->add_option("scene", *file, "SCENE.yaml")->required();
  add_common_flags(*verb, common);
  verb->callback([file, &common] { check(*file, common.quiet); });
}

}  // namespace lrcs
