#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "mesh/closed_shells.h"

namespace lrcs {

// Which closed shells lie inside others.
// A point is inside a shell that a ray from it crosses more often outward than inward, or less often.
// cost: one tree over all facets; five rays for a shell whose box lies in another's. After `most_work` boxes and facets
// held against rays (seconds), every such shell is said to lie inside another, so that it keeps its side.
// check: tests/mesh/enclosure_test.cpp
class Enclosure {
 public:
  static constexpr std::size_t most_work = 20'000'000;

  // Keeps a reference to both.
  Enclosure(const FacetMesh& welded, const std::vector<ClosedShell>& shells);
  ~Enclosure();
  Enclosure(const Enclosure&) = delete;
  Enclosure& operator=(const Enclosure&) = delete;

  // Most of a few points spread over the shell lie inside other ones, whose boxes hold its box: single points may lie
  // on them.
  [[nodiscard]] bool is_inside_another(std::size_t shell);

 private:
  class Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace lrcs
