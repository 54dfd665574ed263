#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cad/read_target.h"
#include "cli/commands.h"
#include "cli/tessellation_flags.h"
#include "mesh/body_frame.h"
#include "mesh/diagnosis.h"
#include "mesh/facet_properties_csv.h"
#include "mesh/info_text.h"

namespace lrcs {

void add_info_command(CLI::App& app, Common& common) {
  struct Options {
    std::string target, facet_properties;
    TessellationFlags file;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("info", "What a target's file holds, and what is wrong with it");
  verb->add_option("target", options->target, "STEP, IGES, BREP, glTF, 3MF, VTP, VTU, STL, OBJ, PLY or OFF file")
      ->required();
  options->file.add_to(*verb);
  verb->add_option("--facet-properties", options->facet_properties, "Table of more properties of facets (CSV)");
  verb->add_flag("--json", options->json, "Print JSON");
  add_common_flags(*verb, common);
  verb->callback([options] {
    const Tessellation tessellation = options->file.tessellation();
    TargetRead read = read_target(options->target, options->file.unit, tessellation);
    if (!options->facet_properties.empty()) add_facet_properties(read.mesh, options->facet_properties);
    place_in_body_frame(read.mesh, read.mesh.metres_per_unit, "+x", "+z");
    const Diagnosis diagnosis = diagnose(read.mesh);
    const FileFacts facts{options->target, read.unit, read.tessellation, read.warnings};
    fmt::print("{}", options->json ? info_json(diagnosis, facts) : info_text(diagnosis, facts));
  });
}

}  // namespace lrcs
