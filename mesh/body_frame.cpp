#include "mesh/body_frame.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

namespace lrcs {
namespace {

Vec3 axis_of(std::string_view word) {
  const std::string_view letter = word.substr(!word.empty() && (word[0] == '+' || word[0] == '-') ? 1 : 0);
  const std::size_t axis = std::string_view("xyz").find(letter);
  if (letter.size() != 1 || axis == std::string_view::npos)
    throw std::invalid_argument(fmt::format("'{}' is no axis, expected one of +x -x +y -y +z -z", word));
  return (word[0] == '-' ? -1.0 : 1.0) * Vec3::Unit(static_cast<Eigen::Index>(axis));
}

}  // namespace

void place_in_body_frame(FacetMesh& mesh, double metres_per_unit, const std::string& forward, const std::string& up) {
  if (!(std::isfinite(metres_per_unit) && metres_per_unit > 0.0))
    throw std::invalid_argument(fmt::format("a unit of {} m, expected a length above zero", metres_per_unit));
  const Vec3 x = axis_of(forward);
  const Vec3 z = axis_of(up);
  if (x.dot(z) != 0.0)
    throw std::invalid_argument(
        fmt::format("forward {} and up {} lie along the same axis, expected two different axes", forward, up));
  const Vec3 y = z.cross(x);
  // The sums have one non-zero term, so they are exact, and 0.0 turns the -0.0 of a flipped axis into 0.0.
  const auto place = [&](Vec3& p) { p = Vec3(p.dot(x) + 0.0, p.dot(y) + 0.0, p.dot(z) + 0.0); };
  for (Vec3& p : mesh.positions) place(p);
  for (CurvedPatch& patch : mesh.curved.patches) {
    for (Vec3& normal : patch.normal) place(normal);
    for (Vec3& sagitta : patch.sagitta) place(sagitta);
  }
  mesh.metres_per_unit = metres_per_unit;
  measure_facets(mesh);
}

}  // namespace lrcs
