#include "bench/curved_bodies.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <numbers>

#include "cad/read_target.h"
#include "lrcs/sweep.h"
#include "mesh/body_frame.h"
#include "mesh/normal_patches.h"
#include "mesh/repair.h"
#include "tests/cad/curved_reference.h"
#include "tests/cad/made_cad.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

constexpr double m = 1000.0;  // [mm]
constexpr double pi = std::numbers::pi;

std::string step_of(const TopoDS_Shape& shape) {
  const ScratchFolder folder;
  MadeCad cad;
  cad.product(shape, "body");
  cad.write_step(folder.path() / "body.step");
  return folder.read("body.step");
}

CurvedBody body_of(const std::string& name, const TopoDS_Shape& shape, const RoundSurface& surface, const Brdf& brdf,
                   const std::vector<Aspect>& aspects) {
  CurvedBody body{name, step_of(shape), aspects, {}};
  for (const Aspect& a : aspects) body.sigma.push_back(unshaded_sigma(surface, brdf, a.to_transmitter, a.to_receiver));
  return body;
}

}  // namespace

std::vector<CurvedBody> curved_bodies(const Brdf& brdf) {
  const std::vector<Aspect> all_round{aspect_between({20, 35}, {20, 35}), aspect_between({77, -12}, {77, -12}),
                                      aspect_between({200, 3}, {200, 3}), aspect_between({20, 35}, {60, 21}),
                                      aspect_between({130, -40}, {75, 5})};
  const std::vector<Aspect> from_above{aspect_between({40, 75}, {40, 75}), aspect_between({10, 62}, {10, 62}),
                                       aspect_between({200, 68}, {200, 68}), aspect_between({40, 80}, {70, 65})};
  const RoundSurface tube{0, 1, [](double) { return Vec3(1, 1, 0); }, {{Vec3(0, 0, 1), pi}, {Vec3(0, 0, -1), pi}}};
  const RoundSurface cone{0, 1, [](double v) { return Vec3((1 - v) * Vec3(3, 3, 1)); }, {{Vec3(0, 0, -1), pi}}};
  return {body_of("sphere", BRepPrimAPI_MakeSphere(m).Shape(), ellipsoid_surface(1, 1, 1), brdf, all_round),
          body_of("cylinder", BRepPrimAPI_MakeCylinder(m, m).Shape(), tube, brdf, all_round),
          body_of("cone", BRepPrimAPI_MakeCone(m, 0, 3 * m).Shape(), cone, brdf, all_round),
          body_of("torus", BRepPrimAPI_MakeTorus(m, 0.4 * m).Shape(), torus_surface(1, 0.4), brdf, from_above),
          body_of("ellipsoid", ellipsoid_of(m, 1, 0.7, 0.5), ellipsoid_surface(1, 0.7, 0.5), brdf, all_round)};
}

Target target_of(const CurvedBody& body, double angle_deg, Facets facets, const Brdf& brdf) {
  const ScratchFolder folder;
  folder.write("body.step", body.step);
  Tessellation tessellation{.relative = 0.01, .absolute = {}, .angle_deg = angle_deg};
  if (facets != Facets::of_surface) tessellation.curving.by = Curving::By::nothing;
  Target target;
  target.mesh = read_target(folder.path() / "body.step", "", tessellation).mesh;
  repair(target.mesh);
  place_in_body_frame(target.mesh, target.mesh.metres_per_unit, "+x", "+z");
  constexpr double crease = 50.0 * pi / 180.0;
  if (facets == Facets::of_estimated_normals) curve_by_normals(target.mesh, estimated_normals(target.mesh, crease));
  target.curved = CurvedSurface(target.mesh);
  target.material.assign(target.mesh.size(), 0);
  target.materials = {{"m", brdf, 0.0, ""}};
  return target;
}

CurvedBody planar_body(const Brdf& brdf) {
  constexpr int along = 12;
  TopoDS_Compound boxes;
  BRep_Builder builder;
  builder.MakeCompound(boxes);
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < along; ++j)
      builder.Add(
          boxes, BRepPrimAPI_MakeBox(gp_Pnt(i * m, j * m, 0), 0.6 * m, 0.7 * m, (1 + (3 * i + 5 * j) % 4) * m).Shape());
  CurvedBody body{
      "boxes", step_of(boxes), {aspect_between({20, 35}, {20, 35}), aspect_between({20, 35}, {60, 21})}, {}};
  for (const SweepRow& row : run_sweep(target_of(body, 30.0, Facets::flat, brdf), body.aspects, 1))
    body.sigma.push_back(row.sigma.value);
  return body;
}

}  // namespace lrcs
