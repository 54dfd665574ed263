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
  RepairCounts repaired;          // all zero for repair: none
  std::string digest;             // SHA-256 of the target's file
  std::string properties_digest;  // the same of the table of facet properties; "": there is none
  std::string unit;               // of its lengths: the scene's, else the file's
  std::string tessellation;       // how facets were made of surfaces; "" where the file holds facets
  std::vector<std::string> warnings;
};

// error: InputError for a file that cannot be used; a pattern that matches nothing; a facet left without a material.
[[nodiscard]] LoadedTarget load_target(const Scene& scene);

// The material of every facet, as an index into the scene's; as of Target (lrcs/cross_section.h).
struct FacetMaterials {
  std::vector<std::uint32_t> front;
  std::vector<std::uint32_t> back;  // empty: everywhere that of the front
};

// The same errors.
[[nodiscard]] FacetMaterials assign_materials(const FacetMesh& mesh, const Scene& scene);

}  // namespace lrcs
