#include "cli/tessellation_flags.h"

#include <CLI/CLI.hpp>

#include "cli/flag_words.h"
#include "lrcs/scene.h"

namespace lrcs {

void TessellationFlags::add_to(CLI::App& verb) {
  verb.add_option("--unit", unit, "Unit of the target's coordinates (mm, m, inch, ...)");
  verb.add_option("--chord-tolerance", chord_tolerance,
                  "How far facets may lie off CAD surfaces: of a part's size (default 1e-3), or a length");
  verb.add_option("--chord-angle", chord_angle, "Largest turn from facet to facet of CAD surfaces [deg] (default 8)");
}

Tessellation TessellationFlags::tessellation() const {
  if (!unit.empty()) (void)checked_unit(unit, Place{"--unit"});
  Tessellation wanted;
  if (!chord_tolerance.empty()) set_chord_tolerance(wanted, chord_tolerance, Place{"--chord-tolerance"});
  if (!chord_angle.empty())
    set_chord_angle(wanted, number_from_words(chord_angle, "--chord-angle"), Place{"--chord-angle"});
  return wanted;
}

}  // namespace lrcs
