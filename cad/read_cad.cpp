#include "cad/read_cad.h"

#include <fmt/format.h>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/input_error.h"
#include "base/length.h"
#include "cad/cad_parts.h"
#include "cad/curved_face.h"
#include "cad/fitted_facets.h"
#include "cad/near_points.h"
#include "cad/shape_size.h"
#include "mesh/mesh_builder.h"

namespace lrcs {
namespace {

using Facets = std::vector<std::array<std::uint32_t, 3>>;

double chord_tolerance(const TopoDS_Shape& product, const Tessellation& wanted, double metres_per_unit) {
  const double diagonal = diagonal_of(product);
  if (!(diagonal > 0.0)) return 0.0;
  // Below its own tolerance Open CASCADE refuses to work.
  return std::max(wanted.absolute ? *wanted.absolute / metres_per_unit : wanted.relative * diagonal,
                  Precision::Confusion());
}

void tessellate(const TopoDS_Shape& product, double chord, double angle_deg) {
  if (!(chord > 0.0)) return;
  IMeshTools_Parameters parameters;
  parameters.Deflection = parameters.DeflectionInterior = chord;
  parameters.Angle = angle_deg * std::numbers::pi / 180.0;
  parameters.InParallel = false;
  BRepMesh_IncrementalMesh(product, parameters);
}

// The facets of placed faces, in the order of the file.
class Builder {
 public:
  explicit Builder(bool curved) : curved_wanted_(curved) {}

  // chord: the tolerance of the part's tessellation.
  void add(const CadPart& part, double chord) {
    builder_.begin_part(part.path);
    NearPoints points(weld_tolerance(part, chord));
    for (const CadFace& face : part.faces) {
      builder_.begin_material(face.look.material);
      builder_.begin_colour(face.look.colour);
      builder_.begin_layer(face.look.layer);
      add(face.face, part.path, points);
    }
  }

  [[nodiscard]] FacetMesh finish() {
    FacetMesh mesh = builder_.finish();
    if (!curved_.patches.empty()) mesh.curved = std::move(curved_);
    return mesh;
  }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  // Faces meet within their edges' tolerance, or within the digits of a file (IGES: 1e-7 of a part's size, which is
  // 1e-4 of the usual chord tolerance); a tolerance above a hundredth of the facets' own error is not believed.
  static double weld_tolerance(const CadPart& part, double chord) {
    double most = Precision::Confusion();
    for (const CadFace& face : part.faces)
      for (TopExp_Explorer edge(face.face, TopAbs_EDGE); edge.More(); edge.Next())
        most = std::max(most, BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())));
    return std::max({Precision::Confusion(), std::min(most, 0.01 * chord), 1e-4 * chord});
  }

  void add(const TopoDS_Face& face, const std::string& path, NearPoints& points) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
    if (triangles.IsNull() || triangles->NbTriangles() == 0) {
      warn_of_lost_face(path);
      return;
    }
    const gp_Trsf& placed = location.Transformation();
    std::vector<std::uint32_t> corner;
    corner.reserve(static_cast<std::size_t>(triangles->NbNodes()));
    for (int k = 1; k <= triangles->NbNodes(); ++k) {
      const gp_Pnt p = triangles->Node(k).Transformed(placed);
      if (!is_coordinate(p.X()) || !is_coordinate(p.Y()) || !is_coordinate(p.Z())) {
        warn_of_lost_face(path);
        return;
      }
      const Vec3 position(p.X(), p.Y(), p.Z());
      const auto next = static_cast<std::uint32_t>(builder_.position_count());
      corner.push_back(points.find_or_add(position, next));
      if (corner.back() == next) builder_.add_position(position);
    }
    const bool turn = (face.Orientation() == TopAbs_REVERSED) != placed.IsNegative();
    CurvedFace curved;
    NodeTriples triples = node_triples(*triangles);
    // What Open CASCADE cannot evaluate stays flat.
    try {
      if (curved_wanted_) fit(face, turn, *triangles, corner, curved, triples);
    } catch (const Standard_Failure&) {
      curved = CurvedFace();
      triples = node_triples(*triangles);
    }
    const auto number = [&](int node) { return corner[static_cast<std::size_t>(node)]; };
    facets_.clear();
    for (const auto& [a, b, c] : triples) {
      std::array<std::uint32_t, 3> facet{number(a), number(b), number(c)};
      if (turn) std::swap(facet[1], facet[2]);
      const auto at = [&](std::size_t k) { return builder_.position(facet[k]); };
      add_patch(curved.patch(a + 1, b + 1, c + 1, {at(0), at(1), at(2)}));
      facets_.push_back(facet);
    }
    builder_.add_facets(facets_);
  }

  // The facets of a tessellation, by nodes from 0.
  static NodeTriples node_triples(const Poly_Triangulation& triangles) {
    NodeTriples facets;
    facets.reserve(static_cast<std::size_t>(triangles.NbTriangles()));
    for (int k = 1; k <= triangles.NbTriangles(); ++k) {
      auto& [a, b, c] = facets.emplace_back();
      triangles.Triangle(k).Get(a, b, c);
      --a, --b, --c;
    }
    return facets;
  }

  void fit(const TopoDS_Face& face, bool turn, const Poly_Triangulation& triangles, std::vector<std::uint32_t>& corner,
           CurvedFace& curved, NodeTriples& facets) {
    curved = CurvedFace(face, turn);
    if (!curved.is_known()) return;
    std::vector<FaceNode> nodes;
    nodes.reserve(corner.size());
    for (int k = 0; k < triangles.NbNodes(); ++k) {
      const gp_Pnt2d uv = triangles.UVNode(k + 1);
      nodes.push_back(
          {builder_.position(corner[static_cast<std::size_t>(k)]), {uv.X(), uv.Y()}, curved.pole_of(k + 1)});
    }
    fit_to_surface(facets, nodes, curved.surface());
    for (std::size_t k = corner.size(); k < nodes.size(); ++k) {
      curved.add_node(nodes[k].uv);
      corner.push_back(builder_.add_position(nodes[k].at));
    }
  }

  void add_patch(const std::optional<CurvedPatch>& patch) {
    curved_.of.push_back(patch ? static_cast<std::uint32_t>(curved_.patches.size()) : CurvedFacets::flat);
    if (patch) curved_.patches.push_back(*patch);
  }

  void warn_of_lost_face(const std::string& path) {
    if (path == lost_in_)
      ++lost_;
    else
      lost_ = 1;
    const std::string warning =
        fmt::format("part '{}': {} of its faces could not be made facets: they are missing", path, lost_);
    if (path == lost_in_)
      warnings_.back() = warning;
    else
      warnings_.push_back(warning);
    lost_in_ = path;
  }

  MeshBuilder builder_;
  Facets facets_;
  CurvedFacets curved_;
  bool curved_wanted_;
  std::vector<std::string> warnings_;
  std::string lost_in_;
  int lost_ = 0;
};

// Metres in what Open CASCADE has for 1.
double metres_per_unit_of(const CadDocument& document, const std::string& unit, const std::string& file) {
  if (unit.empty()) return document.unit.empty() ? 1.0 : 1e-3;
  if (!document.unit.empty() && document.unit_mm == 0.0)
    throw InputError(Place{file}, fmt::format("its lengths are in several units, or in one that is not known here, and "
                                              "cannot be taken for {}: expected no unit to be asked for",
                                              unit));
  return document.unit.empty() ? metres_in(unit) : metres_in(unit) / document.unit_mm;
}

ImportedMesh read(const std::filesystem::path& file, FileFormat format, const std::string& unit,
                  const Tessellation& wanted) {
  const CadDocument document = read_cad_document(file, format);
  const double metres_per_unit = metres_per_unit_of(document, unit, file.string());
  ImportedMesh cad;
  cad.unit = unit.empty() ? document.unit : unit;
  Builder builder(wanted.curving.by == Curving::By::cad_surfaces);
  TopTools_MapOfShape known;
  for (const CadPart& part : cad_parts(document, file.string())) {
    const double chord = chord_tolerance(part.body, wanted, metres_per_unit);
    if (known.Add(part.body)) tessellate(part.body, chord, wanted.angle_deg);
    builder.add(part, chord);
  }
  cad.mesh = builder.finish();
  cad.mesh.metres_per_unit = metres_per_unit;
  cad.warnings = document.warnings;
  cad.warnings.insert(cad.warnings.end(), builder.warnings().begin(), builder.warnings().end());
  if (cad.mesh.size() == 0)
    throw InputError(Place{file.string()}, "holds no surface that can be made facets, expected at least one");
  return cad;
}

}  // namespace

ImportedMesh read_cad(const std::filesystem::path& file, FileFormat format, const std::string& unit,
                      const Tessellation& tessellation) {
  try {
    return read(file, format, unit, tessellation);
  } catch (const Standard_Failure& failure) {
    throw InputError(Place{file.string()}, fmt::format("Open CASCADE cannot use it: {} {}",
                                                       failure.DynamicType()->Name(), failure.GetMessageString()));
  }
}

}  // namespace lrcs
