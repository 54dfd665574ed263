#pragma once
#include <string>

#include "lrcs/cross_section.h"
#include "lrcs/scene.h"
#include "mesh/facet_mesh.h"
#include "mesh/repair.h"

namespace lrcs {

// A scene's target, read, repaired as asked, in the body frame, every facet with its material.
struct LoadedTarget {
  Target target;
  RepairCounts repaired;     // all zero for repair: none
  std::string digest;        // SHA-256 of the target's file
  std::string unit;          // of its lengths: the scene's, else the file's
  std::string tessellation;  // how facets were made of surfaces; "" where the file holds facets
  std::vector<std::string> warnings;
};

// error: InputError for a file that cannot be used; a pattern that matches nothing; a facet left without a material.
[[nodiscard]] LoadedTarget load_target(const Scene& scene);

// Index of the material of every facet. The same errors.
[[nodiscard]] std::vector<std::uint32_t> assign_materials(const FacetMesh& mesh, const Scene& scene);

}  // namespace lrcs
