#include "view/solid_drawing.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "view/facet_colours.h"
#include "view/offscreen.h"

namespace lrcs {
namespace {

// In the view's own axes and pixels: right, up, toward the viewer.
vtkSmartPointer<vtkPolyData> triangles_in_view(const FacetMesh& mesh, const ParallelView& view) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p : mesh.positions) {
    const Point at = view.at(p);
    points->InsertNextPoint(at.x, at.y, view.pixels_a_metre * view.backward.dot(p - view.centre));
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& facet : mesh.facets) triangles->InsertNextCell({facet[0], facet[1], facet[2]});
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

vtkSmartPointer<vtkUnsignedCharArray> shaded(const FacetMesh& mesh, const std::vector<Colour>& colours,
                                             const ParallelView& view) {
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < mesh.size(); ++i)
    array->InsertNextTypedTuple(drawn_colour(colours[i], false, mesh.normals[i].dot(view.backward)).data());
  return array;
}

vtkSmartPointer<vtkActor> facets_actor(vtkPolyData* triangles) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(triangles);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

// Drawn a little nearer than the facets they bound, so that these do not swallow half of them.
vtkSmartPointer<vtkActor> creases_actor(vtkPolyData* triangles, double line_width) {
  constexpr double sharp = 30.0;   // [deg]
  constexpr double nearer = 0.75;  // [pixel]
  constexpr double same = 1e-3;    // corners this near are one: far below what can be seen [pixel]
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputData(triangles);
  welded->ToleranceIsAbsoluteOn();
  welded->SetAbsoluteTolerance(same);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(welded->GetOutputPort());
  edges->SetFeatureAngle(sharp);
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(0.0, 0.0, nearer);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(ink.red, ink.green, ink.blue);
  actor->GetProperty()->SetLineWidth(static_cast<float>(line_width));
  return actor;
}

// From well in front of everything, with the clipping planes clear of it: a parallel projection too leaves out what
// lies nearer than its near plane.
void look_straight_down(vtkRenderer* renderer, int width, int height) {
  const double* bounds = renderer->ComputeVisiblePropBounds();
  const double clear = bounds[5] - bounds[4] + 10.0;  // [pixel]
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height);
  camera->SetFocalPoint(0.5 * width, 0.5 * height, bounds[4]);
  camera->SetPosition(0.5 * width, 0.5 * height, bounds[5] + 2.0 * clear);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(clear, 4.0 * clear);
}

}  // namespace

Picture solid_drawing(const FacetMesh& mesh, const std::vector<Colour>& colours, const ParallelView& view, int width,
                      int height) {
  const int fine = offscreen_fineness(width, height);
  const auto triangles = triangles_in_view(mesh, view);
  triangles->GetCellData()->SetScalars(shaded(mesh, colours, view));
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(facets_actor(triangles));
  renderer->AddActor(creases_actor(triangles, 1.6 * fine));
  look_straight_down(renderer, width, height);
  return shrunk(drawn_offscreen({renderer}, fine * width, fine * height), fine);
}

}  // namespace lrcs
