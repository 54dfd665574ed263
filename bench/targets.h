#pragma once
#include <string>
#include <vector>

#include "mesh/facet_mesh.h"

namespace lrcs {

// The targets to measure on: files shipped with the project, and made ones.
[[nodiscard]] const std::vector<std::string>& known_targets();
// Those whose cost is compared over their number of facets, and those of the short run.
[[nodiscard]] const std::vector<std::string>& bumpy_spheres();
[[nodiscard]] const std::vector<std::string>& short_targets();

// A known target, or else the mesh file of that name; repaired, as `lrcs sweep` does.
// error: InputError for a file that cannot be used.
[[nodiscard]] FacetMesh target_mesh(const std::string& name);

// For tables and file names: "tess" of "/some/where/tess.obj".
[[nodiscard]] std::string short_name(const std::string& target);

}  // namespace lrcs
