#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "base/length.h"
#include "cli/commands.h"
#include "lrcs/scene.h"
#include "mesh/body_frame.h"
#include "mesh/diagnosis.h"
#include "mesh/info_text.h"
#include "mesh/read_mesh.h"

namespace lrcs {

void add_info_command(CLI::App& app, Common& common) {
  struct Options {
    std::string target, unit;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("info", "What a target's file holds, and what is wrong with it");
  verb->add_option("target", options->target, "STL, OBJ, PLY or OFF file")->required();
  verb->add_option("--unit", options->unit, "Unit of the target's coordinates (mm, m, inch, ...)");
  verb->add_flag("--json", options->json, "Print JSON");
  add_common_flags(*verb, common);
  verb->callback([options] {
    const double metres = options->unit.empty() ? 1.0 : checked_unit(options->unit, Place{"--unit"});
    FacetMesh mesh = read_mesh(options->target);
    place_in_body_frame(mesh, metres, "+x", "+z");
    const Diagnosis diagnosis = diagnose(mesh);
    fmt::print("{}", options->json ? info_json(diagnosis, options->unit)
                                   : info_text(diagnosis, options->target, options->unit));
  });
}

}  // namespace lrcs
