#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "lrcs/scene.h"
#include "lrcs/scene_target.h"
#include "lrcs/skips.h"
#include "lrcs/sweep.h"

namespace lrcs {

// A facet file of a run.
struct FacetFile {
  std::size_t k = 0;    // its place in output.facets, or the row for facets: all
  std::size_t row = 0;  // of the sweep, from 0
  std::string name;     // facets-k.vtp
  Aspect aspect;
};

// How a run went, for manifest.json.
struct RunFacts {
  std::vector<std::string> command;  // the program's arguments
  std::string started_utc;           // ISO 8601
  double read_seconds = 0.0, sweep_seconds = 0.0;
  std::size_t threads = 0;
  std::vector<std::string> warnings;
  std::vector<std::pair<std::string, std::string>> outputs;  // file name, SHA-256
  std::vector<FacetFile> facets;
  SkipCounts skipped;
  MethodCounts methods;
};

// The content of manifest.json: inputs with digests, version, command, what was repaired, materials, conventions,
// times, outputs with digests, the direction of every facet file, what was skipped, warnings.
[[nodiscard]] std::string manifest_json(const Scene& scene, const LoadedTarget& loaded, const RunFacts& facts);

}  // namespace lrcs
