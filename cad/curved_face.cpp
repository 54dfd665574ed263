#include "cad/curved_face.h"

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "cad/fitted_facets.h"
#include "mesh/facet_mesh.h"

namespace lrcs {
namespace {

// Gauss' rule of 8 places in 0..1.
struct Gauss {
  static constexpr std::size_t size = 8;
  static double at(std::size_t k) { return 0.5 * (k % 2 == 0 ? 1.0 + places[k / 2] : 1.0 - places[k / 2]); }
  static double weight(std::size_t k) { return 0.5 * weights[k / 2]; }

  static constexpr std::array<double, 4> places{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                0.9602898564975363};
  static constexpr std::array<double, 4> weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                 0.1012285362903763};
};

Vec3 vec3(const gp_Vec& v) {
  return {v.X(), v.Y(), v.Z()};
}

bool is_planar(const CurvedPatch& patch, const Vec3& flat) {
  const double area = flat.norm();
  for (std::size_t k = 0; k < PatchRule::size; ++k)
    if (!((patch.area[k] * patch.normal[k] - flat).norm() <= patch_alike * area)) return false;
  return true;
}

// Whether a patch may stand over its facet: a file's parameters may say something else than its points.
bool is_near(const CurvedPatch& patch, const Vec3& flat, const std::array<Vec3, 3>& corners) {
  double longest2 = 0.0;
  for (std::size_t k = 0; k < 3; ++k) longest2 = std::max(longest2, (corners[(k + 1) % 3] - corners[k]).squaredNorm());
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < PatchRule::size; ++k) sum += patch_rule().weight[k] * patch.area[k] * patch.normal[k];
  return (sum - flat).norm() <= 0.25 * longest2;
}

bool is_finite(const CurvedPatch& patch) {
  for (std::size_t k = 0; k < PatchRule::size; ++k)
    if (!(std::isfinite(patch.area[k]) && patch.normal[k].allFinite())) return false;
  return std::ranges::all_of(patch.sagitta, [](const Vec3& sagitta) { return sagitta.allFinite(); });
}

}  // namespace

CurvedFace::CurvedFace(const TopoDS_Face& face, bool turned)
    : surface_(face, false), triangles_(BRep_Tool::Triangulation(face, location_)), turned_(turned) {
  if (triangles_.IsNull() || !triangles_->HasUVNodes()) return;
  poles_.assign(static_cast<std::size_t>(triangles_->NbNodes()) + 1, -1);
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) add_edge(face, TopoDS::Edge(edge.Current()));
  known_ = lies_on_surface(face);
}

void CurvedFace::add_edge(const TopoDS_Face& face, const TopoDS_Edge& edge) {
  const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, triangles_, location_);
  double first = 0.0, last = 0.0;
  if (polygon.IsNull() || !polygon->HasParameters() || BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull())
    return;
  const BRepAdaptor_Curve2d curve(edge, face);
  if (BRep_Tool::Degenerated(edge)) {
    const gp_Pnt2d a = curve.Value(first), b = curve.Value(last);
    const int pole = std::abs(b.X() - a.X()) >= std::abs(b.Y() - a.Y()) ? 0 : 1;
    for (int k = 1; k <= polygon->NbNodes(); ++k) poles_[static_cast<std::size_t>(polygon->Node(k))] = pole;
    return;
  }
  curves_.push_back(curve);
  for (int k = 1; k < polygon->NbNodes(); ++k)
    sides_[{polygon->Node(k), polygon->Node(k + 1)}] = {curves_.size() - 1, polygon->Parameter(k),
                                                        polygon->Parameter(k + 1)};
}

// Files may say parameters that contradict the points.
bool CurvedFace::lies_on_surface(const TopoDS_Face& face) const {
  double tolerance = std::max(BRep_Tool::Tolerance(face), Precision::Confusion());
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
    tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())));
  for (TopExp_Explorer vertex(face, TopAbs_VERTEX); vertex.More(); vertex.Next())
    tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Vertex(vertex.Current())));
  const gp_Trsf& placed = location_.Transformation();
  for (int k = 1; k <= triangles_->NbNodes(); ++k) {
    const gp_Pnt2d at = triangles_->UVNode(k);
    if (!(surface_.Value(at.X(), at.Y()).Distance(triangles_->Node(k).Transformed(placed)) <= 2.0 * tolerance))
      return false;
  }
  return true;
}

void CurvedFace::add_node(const Uv& uv) {
  added_.push_back(uv);
  poles_.push_back(-1);
}

CurvedFace::Uv CurvedFace::uv(int node) const {
  if (node > triangles_->NbNodes()) return added_[static_cast<std::size_t>(node - triangles_->NbNodes()) - 1];
  const gp_Pnt2d p = triangles_->UVNode(node);
  return {p.X(), p.Y()};
}

std::optional<CurvedFace::Bend> CurvedFace::bend(int from, int to, double along) const {
  auto found = sides_.find({from, to});
  const bool backward = found == sides_.end();
  if (backward) found = sides_.find({to, from});
  if (found == sides_.end()) return std::nullopt;
  const auto& [curve, low, high] = found->second;
  const double first = backward ? high : low, last = backward ? low : high;
  const auto at = [&, k = curve](double share, gp_Pnt2d& p, gp_Vec2d& d) {
    curves_[k].D1(first + share * (last - first), p, d);
  };
  gp_Pnt2d begin, end, here;
  gp_Vec2d slope;
  at(0.0, begin, slope);
  at(1.0, end, slope);
  at(along, here, slope);
  const Uv chord(end.X() - begin.X(), end.Y() - begin.Y());
  // A curve that begins or ends elsewhere is followed all the same, from node to node.
  return Bend{Uv(here.X() - begin.X(), here.Y() - begin.Y()) - along * chord,
              Uv(slope.X(), slope.Y()) * (last - first) - chord};
}

CurvedFace::Mapped CurvedFace::map(const std::array<int, 3>& nodes, const std::array<double, 3>& place) const {
  const std::array<Uv, 3> corner{uv(nodes[0]), uv(nodes[1]), uv(nodes[2])};
  Mapped mapped{corner[0] * place[0] + corner[1] * place[1] + corner[2] * place[2], corner[1] - corner[0],
                corner[2] - corner[0]};
  std::array<Uv, 3> by{Uv::Zero(), Uv::Zero(), Uv::Zero()};  // of the bends, by each weight
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3;
    const double along = 0.5 * (1.0 + place[k] - place[j]), rest = 1.0 - along;
    const auto bent = bend(nodes[j], nodes[k], along);
    if (!bent) continue;
    // The bend over along (1 - along), which is smooth, times the product of the side's two weights.
    const Uv shape = bent->value / (along * rest);
    const Uv slope = (bent->slope - shape * (rest - along)) / (along * rest);
    mapped.at += place[j] * place[k] * shape;
    by[j] += place[k] * shape - 0.5 * place[j] * place[k] * slope;
    by[k] += place[j] * shape + 0.5 * place[j] * place[k] * slope;
  }
  mapped.by_first += by[1] - by[0];
  mapped.by_second += by[2] - by[0];
  return mapped;
}

CurvedFace::Mapped CurvedFace::map_at_pole(const std::array<int, 3>& nodes, std::size_t pole,
                                           const std::array<double, 3>& place) const {
  const int from = nodes[(pole + 1) % 3], to = nodes[(pole + 2) % 3];
  const double rise = place[pole], along = place[(pole + 2) % 3] / (1.0 - rise);
  Uv base = uv(from) + along * (uv(to) - uv(from)), by_along = uv(to) - uv(from);
  if (const auto bent = bend(from, to, along)) base += bent->value, by_along += bent->slope;
  const Eigen::Index across = 1 - pole_of(nodes[pole]);
  Uv at = base, by_rise = Uv::Zero();
  by_rise[across] = uv(nodes[pole])[across] - base[across];
  at[across] += rise * by_rise[across];
  by_along[across] *= 1.0 - rise;
  // d(second weight) d(third weight) = (1 - rise) d(along) d(rise): the sign, by the order of the corners.
  return {at, by_along / (1.0 - rise), by_rise};
}

// The derivatives by both parameters, one across the other.
Vec3 CurvedFace::across(const Uv& at) const {
  gp_Pnt point;
  gp_Vec by_u, by_v;
  surface_.D1(at.x(), at.y(), point, by_u, by_v);
  return vec3(by_u).cross(vec3(by_v));
}

// In how far along the side opposite to the pole, and how far up to the pole, all is smooth.
double CurvedFace::pole_area(const std::array<int, 3>& nodes, std::size_t pole) const {
  double area = 0.0;
  for (std::size_t i = 0; i < Gauss::size; ++i)
    for (std::size_t j = 0; j < Gauss::size; ++j) {
      const double rise = Gauss::at(i), along = Gauss::at(j);
      std::array<double, 3> place{};
      place[pole] = rise;
      place[(pole + 1) % 3] = (1.0 - rise) * (1.0 - along);
      place[(pole + 2) % 3] = (1.0 - rise) * along;
      const Mapped mapped = map_at_pole(nodes, pole, place);
      area += Gauss::weight(i) * Gauss::weight(j) * (1.0 - rise) * across(mapped.at).norm() *
              cross(mapped.by_first, mapped.by_second);
    }
  return area;
}

// Of the facet in its plane, whose parameters are lengths: the triangle, and what its sides' curves hold beyond it.
double CurvedFace::plane_area(const std::array<int, 3>& nodes) const {
  double twice = cross(uv(nodes[1]) - uv(nodes[0]), uv(nodes[2]) - uv(nodes[0]));
  for (std::size_t j = 0; j < 3; ++j) {
    const int from = nodes[j], to = nodes[(j + 1) % 3];
    const Uv chord = uv(to) - uv(from);
    for (std::size_t g = 0; g < Gauss::size; ++g) {
      // Along the chord c plus the bend b from its begin: (t c + b) x (c + b') = b x c + t c x b' + b x b', the second
      // of which integrates to b x c, too.
      if (const auto bent = bend(from, to, Gauss::at(g)))
        twice += Gauss::weight(g) * (2.0 * cross(bent->value, chord) + cross(bent->value, bent->slope));
    }
  }
  return 0.5 * twice;
}

std::optional<CurvedPatch> CurvedFace::patch(int a, int b, int c, const std::array<Vec3, 3>& corners) const try {
  if (!known_) return std::nullopt;
  const Vec3 flat = 0.5 * facet_cross(corners[0], corners[1], corners[2]);
  const std::array<int, 3> nodes{a, b, c};
  std::size_t poles = 0, pole = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (pole_of(nodes[k]) >= 0) ++poles, pole = k;
  if (poles > 1) return std::nullopt;
  const bool plane = surface_.GetType() == GeomAbs_Plane;
  CurvedPatch patch;
  for (std::size_t k = 0; k < PatchRule::size; ++k) {
    std::array<double, 3> place = patch_rule().at[k];
    if (turned_) std::swap(place[1], place[2]);
    const Mapped mapped = poles == 1 ? map_at_pole(nodes, pole, place) : map(nodes, place);
    const Vec3 normal = across(mapped.at);
    const double stretch = normal.norm();
    patch.normal[k] = (turned_ ? -normal : normal) / stretch;
    patch.area[k] = plane ? plane_area(nodes) * stretch : 0.5 * stretch * cross(mapped.by_first, mapped.by_second);
  }
  // A plane's facets count evenly, its rim's curves included.
  for (std::size_t k = 0; k < 3 && !plane; ++k) {
    const std::size_t next = (k + 1) % 3;
    std::array<double, 3> place{};
    place[k] = place[next] = 0.5;
    if (turned_) std::swap(place[1], place[2]);
    const Uv at = (poles == 1 ? map_at_pole(nodes, pole, place) : map(nodes, place)).at;
    const gp_Pnt p = surface_.Value(at.x(), at.y());
    patch.sagitta[k] = Vec3(p.X(), p.Y(), p.Z()) - 0.5 * (corners[k] + corners[next]);
  }
  if (poles == 1) {
    // However wide the facet is at the pole, its area is right.
    double sum = 0.0;
    for (std::size_t k = 0; k < PatchRule::size; ++k) sum += patch_rule().weight[k] * patch.area[k];
    const double share = pole_area(nodes, pole) / sum;
    for (double& area : patch.area) area *= share;
  }
  if (!is_finite(patch) || is_planar(patch, flat) || !is_near(patch, flat, corners)) return std::nullopt;
  return patch;
} catch (const Standard_Failure&) {
  return std::nullopt;
}

}  // namespace lrcs
