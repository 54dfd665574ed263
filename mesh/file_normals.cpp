#include "mesh/file_normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/input_error.h"
#include "mesh/corner_normals.h"
#include "mesh/normal_patches.h"

namespace lrcs {
namespace {

// Turns normals that all point to a facet's back; do they?
bool turn_to_front(std::array<Vec3, 3>& normals, const Vec3& front) {
  const bool against = std::all_of(normals.begin(), normals.end(), [&](const Vec3& n) { return n.dot(front) < 0.0; });
  if (against)
    for (Vec3& n : normals) n = -n;
  return against;
}

std::string face_of(const FacetMesh& mesh, std::uint32_t facet) {
  return fmt::format("face {} as read (from 0)", mesh.source_facet[facet]);
}

}  // namespace

void FileNormals::add(const Vec3& normal, int line) {
  normals_.push_back(normal);
  if (line > 0) lines_.push_back(line);
}

void FileNormals::add(TextScanner& scanner) {
  Vec3 normal;
  for (double& x : normal) x = scanner.number_in(scanner.word(), "a component of a normal, a finite number");
  add(normal, scanner.line());
}

bool FileNormals::add_polygon(std::span<const std::uint32_t> vertices, std::span<const std::uint32_t> numbers,
                              std::span<const std::array<std::uint32_t, 3>> facets) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> known;
  known.reserve(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k) known.emplace_back(vertices[k], numbers[k]);
  std::sort(known.begin(), known.end());
  // A triangle with one vertex twice has no area, and no use for normals.
  for (std::size_t k = 1; k < known.size() && vertices.size() > 3; ++k)
    if (known[k].first == known[k - 1].first && normals_[known[k].second] != normals_[known[k - 1].second])
      return false;
  for (const auto& facet : facets) {
    auto& corners = corners_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = std::lower_bound(known.begin(), known.end(), std::pair(facet[k], std::uint32_t{0}))->second;
  }
  return true;
}

Vec3 FileNormals::unit(std::uint32_t number, std::uint32_t face, const std::string& file) const {
  const Vec3& n = normals_[number];
  const double length = n.stableNorm();
  if (length > 0.0 && std::isfinite(length)) return n.stableNormalized();
  throw InputError(Place{file, lines_.empty() ? 0 : lines_[number]},
                   fmt::format("normal {} as read (from 0), which its face {} has, is ({}, {}, {}), expected a "
                               "length above 0",
                               number, face, n.x(), n.y(), n.z()));
}

void FileNormals::curve(FacetMesh& mesh, const std::string& file, std::vector<std::string>& warnings) const {
  if (normals_.empty())
    throw InputError(Place{file}, "has no normals at its vertices, expected them for curved: file_normals");
  const auto& numbers = corners_.empty() ? mesh.facets : corners_;
  CornerNormals normals(mesh.size());
  std::vector<std::uint32_t> against;
  for (std::uint32_t f = 0; f < mesh.size(); ++f) {
    if (mesh.areas[f] == 0.0) continue;
    for (std::size_t k = 0; k < 3; ++k) normals[f][k] = unit(numbers[f][k], mesh.source_facet[f], file);
    if (turn_to_front(normals[f], mesh.normals[f])) against.push_back(f);
  }
  if (!against.empty())
    warnings.push_back(
        fmt::format("{} of {} facets are wound against their normals, first {}: which side is the front is told by the "
                    "winding, the normals only bend",
                    against.size(), mesh.size(), face_of(mesh, against[0])));
  if (const auto flat = curve_by_normals(mesh, normals); !flat.empty())
    warnings.push_back(fmt::format("{} facets stay flat: a normal in the file is more than 60 deg off them, first {}",
                                   flat.size(), face_of(mesh, flat[0])));
  if (mesh.curved.patches.empty())
    warnings.emplace_back("file_normals bends no facet: where the normals are of use, they are the facets' own");
}

}  // namespace lrcs
