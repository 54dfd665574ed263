#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "base/length.h"
#include "cad/read_target.h"
#include "cli/commands.h"
#include "cli/flag_words.h"
#include "lrcs/scene.h"
#include "mesh/body_frame.h"
#include "mesh/diagnosis.h"
#include "mesh/facet_properties_csv.h"
#include "mesh/info_text.h"

namespace lrcs {

void add_info_command(CLI::App& app, Common& common) {
  struct Options {
    std::string target, unit, chord_tolerance, chord_angle, facet_properties;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("info", "What a target's file holds, and what is wrong with it");
  verb->add_option("target", options->target, "STEP, IGES, BREP, glTF, 3MF, VTP, VTU, STL, OBJ, PLY or OFF file")
      ->required();
  verb->add_option("--unit", options->unit, "Unit of the target's coordinates (mm, m, inch, ...)");
  verb->add_option("--chord-tolerance", options->chord_tolerance,
                   "How far facets may lie off CAD surfaces: of a part's size (default 1e-3), or a length");
  verb->add_option("--chord-angle", options->chord_angle,
                   "Largest turn from facet to facet of CAD surfaces [deg] (default 8)");
  verb->add_option("--facet-properties", options->facet_properties, "Table of more properties of facets (CSV)");
  verb->add_flag("--json", options->json, "Print JSON");
  add_common_flags(*verb, common);
  verb->callback([options] {
    if (!options->unit.empty()) (void)checked_unit(options->unit, Place{"--unit"});
    Tessellation tessellation;
    if (!options->chord_tolerance.empty())
      set_chord_tolerance(tessellation, options->chord_tolerance, Place{"--chord-tolerance"});
    if (!options->chord_angle.empty())
      set_chord_angle(tessellation, number_from_words(options->chord_angle, "--chord-angle"), Place{"--chord-angle"});
    TargetRead read = read_target(options->target, options->unit, tessellation);
    if (!options->facet_properties.empty()) add_facet_properties(read.mesh, options->facet_properties);
    place_in_body_frame(read.mesh, read.mesh.metres_per_unit, "+x", "+z");
    const Diagnosis diagnosis = diagnose(read.mesh);
    const FileFacts facts{options->target, read.unit, read.tessellation, read.warnings};
    fmt::print("{}", options->json ? info_json(diagnosis, facts) : info_text(diagnosis, facts));
  });
}

}  // namespace lrcs
