#pragma once
#include <string>

#include "cad/tessellation.h"

namespace CLI {
class App;
}

namespace lrcs {

// The flags --unit, --chord-tolerance and --chord-angle of verbs that look at a target's file by itself.
struct TessellationFlags {
  std::string unit, chord_tolerance, chord_angle;

  // They fill this object, which must stay where it is.
  void add_to(CLI::App& verb);

  // As said, else the default. error: InputError that names the flag, also for a unit that is none.
  [[nodiscard]] Tessellation tessellation() const;
};

}  // namespace lrcs
