#include "bench/targets.h"

#include <filesystem>
#include <functional>
#include <map>

#include "bench/bumpy_sphere.h"
#include "bench/spacecraft.h"
#include "mesh/read_mesh.h"
#include "mesh/repair.h"

namespace lrcs {
namespace {

FacetMesh shipped(const std::string& file) {
  return read_mesh(std::filesystem::path(LRCS_EXAMPLES) / file);
}

const std::map<std::string, std::function<FacetMesh()>>& makers() {
  static const std::map<std::string, std::function<FacetMesh()>> table{
      {"propeller", [] { return shipped("propeller/propeller.stl"); }},
      {"tess", [] { return shipped("tess/tess.obj"); }},
      {"turbine", [] { return shipped("turbine/turbine.off"); }},
      {"spacecraft", spacecraft},
      {"bumpy-32k", [] { return bumpy_sphere(90); }},
      {"bumpy-129k", [] { return bumpy_sphere(180); }},
      {"bumpy-517k", [] { return bumpy_sphere(360); }},
      {"bumpy-2.0M", [] { return bumpy_sphere(708); }},
  };
  return table;
}

}  // namespace

const std::vector<std::string>& known_targets() {
  static const std::vector<std::string> names{"propeller", "tess",       "turbine",    "spacecraft",
                                              "bumpy-32k", "bumpy-129k", "bumpy-517k", "bumpy-2.0M"};
  return names;
}

const std::vector<std::string>& bumpy_spheres() {
  static const std::vector<std::string> names{"bumpy-32k", "bumpy-129k", "bumpy-517k", "bumpy-2.0M"};
  return names;
}

const std::vector<std::string>& short_targets() {
  static const std::vector<std::string> names{"turbine", "spacecraft", "bumpy-32k", "bumpy-129k"};
  return names;
}

FacetMesh target_mesh(const std::string& name) {
  const auto made = makers().find(name);
  FacetMesh mesh = made != makers().end() ? made->second() : read_mesh(name);
  repair(mesh);
  return mesh;
}

std::string short_name(const std::string& target) {
  return makers().contains(target) ? target : std::filesystem::path(target).stem().string();
}

}  // namespace lrcs
