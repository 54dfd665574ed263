#pragma once
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/curved_patch.h"

namespace lrcs {

// The surface of a face of a CAD file over the facets of its tessellation.
// A facet stands for the part of the surface over a triangle of the face's two parameters whose sides are straight
// within the face, and follow the face's edges where it ends: so facets tile the face, and faces meet in their edges.
// At a pole (where an edge has no length) a facet's sides are lines of constant parameter.
class CurvedFace {
 public:
  // domain: tessellated. error: Standard_Failure of Open CASCADE. turned: facets are wound against the surface's own
  // normal.
  CurvedFace(const TopoDS_Face& face, bool turned);
  // Of a face that is to stay flat.
  CurvedFace() = default;

  // Of the facet of three nodes of the triangulation, in its order there; places of the patch go by the facet's
  // corners: (a, b, c), or (a, c, b) of a turned face. corners: where these are. Nothing where the facet is the
  // surface itself, to 1e-12 of its normal and area, or where the surface cannot be had.
  [[nodiscard]] std::optional<CurvedPatch> patch(int a, int b, int c, const std::array<Vec3, 3>& corners) const;

  // Where the surface is a point at a node: the parameter, 0 or 1, along which it is; else -1.
  [[nodiscard]] int pole_of(int node) const { return poles_.empty() ? -1 : poles_[static_cast<std::size_t>(node)]; }
  // Further nodes, within the face, follow those of the triangulation.
  void add_node(const Eigen::Vector2d& uv);
  [[nodiscard]] const BRepAdaptor_Surface& surface() const { return surface_; }

  // Whether the triangulation lies on the surface: else no patch is to be had.
  [[nodiscard]] bool is_known() const { return known_; }

 private:
  using Uv = Eigen::Vector2d;
  // Of an edge, between two neighbouring nodes.
  struct Side {
    std::size_t curve;
    double first, last;  // its parameters
  };
  struct Bend {  // what a side's curve differs from its chord by
    Uv value, slope;
  };
  struct Mapped {  // a place in the parameters, and its derivatives by two weights
    Uv at, by_first, by_second;
  };

  void add_edge(const TopoDS_Face& face, const TopoDS_Edge& edge);
  [[nodiscard]] bool lies_on_surface(const TopoDS_Face& face) const;
  [[nodiscard]] Uv uv(int node) const;
  [[nodiscard]] std::optional<Bend> bend(int from, int to, double along) const;
  [[nodiscard]] Mapped map(const std::array<int, 3>& nodes, const std::array<double, 3>& place) const;
  [[nodiscard]] Mapped map_at_pole(const std::array<int, 3>& nodes, std::size_t pole,
                                   const std::array<double, 3>& place) const;
  [[nodiscard]] double pole_area(const std::array<int, 3>& nodes, std::size_t pole) const;
  [[nodiscard]] Vec3 across(const Uv& at) const;
  [[nodiscard]] double plane_area(const std::array<int, 3>& nodes) const;

  BRepAdaptor_Surface surface_;
  TopLoc_Location location_;
  Handle(Poly_Triangulation) triangles_;
  std::vector<Uv> added_;
  std::vector<BRepAdaptor_Curve2d> curves_;
  std::map<std::pair<int, int>, Side> sides_;  // of nodes in the order of the edge
  std::vector<int> poles_;                     // of each node, which are numbered from 1
  bool turned_ = false, known_ = false;
};

}  // namespace lrcs
