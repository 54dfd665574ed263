#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/text_scanner.h"
#include "mesh/facet_mesh.h"

namespace lrcs {

// The normals that a file gives at its vertices, or at the corners of its faces: taken up as the file is read, and then
// made the facets' curvature. A model, as estimated normals are (mesh/normal_patches.h): of the surface between the
// corners the file says nothing. check: tests/mesh/file_normals_test.cpp, tests/cad/file_normals_test.cpp
class FileNormals {
 public:
  // Adds the next normal, of any length. line: where it stands; 0 in files without lines.
  void add(const Vec3& normal, int line = 0);
  // The same of the next three words of a line. error: InputError for words that are no finite numbers.
  void add(TextScanner& scanner);
  [[nodiscard]] std::size_t size() const { return normals_.size(); }

  // For files with normals of their own at the corners of each face: gives the facets that a polygon was cut into those
  // of its corners, by their numbers, from 0. Is not called for files with a normal a vertex, in the vertices' order.
  // value: false where the polygon passes a vertex twice, with two normals: which facet has which is not known.
  // domain: for every polygon of the mesh, in order; numbers below size(), one a vertex.
  [[nodiscard]] bool add_polygon(std::span<const std::uint32_t> vertices, std::span<const std::uint32_t> numbers,
                                 std::span<const std::array<std::uint32_t, 3>> facets);

  // Makes the facets stand for curved patches with these normals. A facet all of whose normals point to its back keeps
  // the front that its winding gives it, and takes the surface from them; facets of area zero have no use for theirs.
  // domain: the mesh as it was read; whatever changes it later keeps patches in step (mesh/facet_lists.h).
  // error: InputError where there are no normals, or a facet uses one that has no direction.
  // warnings: facets wound against their normals; facets that stay flat since a normal is further off them than
  //   most_turned; that no facet is bent.
  void curve(FacetMesh& mesh, const std::string& file, std::vector<std::string>& warnings) const;

 private:
  [[nodiscard]] Vec3 unit(std::uint32_t number, std::uint32_t face, const std::string& file) const;

  std::vector<Vec3> normals_;
  std::vector<int> lines_;                             // of each normal; empty: the file has none
  std::vector<std::array<std::uint32_t, 3>> corners_;  // the numbers at the facets' corners; empty: as the vertices'
};

}  // namespace lrcs
