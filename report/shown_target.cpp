#include "report/shown_target.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>

#include "mesh/facet_lists.h"

namespace lrcs {
namespace {

std::array<float, 3> rounded(const Vec3& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

ShownTarget as_it_is(const FacetMesh& mesh) {
  ShownTarget shown;
  for (const Vec3& p : mesh.positions) shown.positions.push_back(rounded(mesh.metres_per_unit * p));
  shown.triangles = mesh.facets;
  shown.part = mesh.part.of;
  shown.area = mesh.areas;
  for (std::uint32_t k = 0; k < mesh.size(); ++k) shown.shown_of.push_back(k);
  shown.value_of = shown.shown_of;
  return shown;
}

vtkSmartPointer<vtkPolyData> facets_of(const FacetMesh& mesh, const std::vector<std::uint32_t>& facets) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (const std::uint32_t k : facets) {
    std::array<vtkIdType, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 p = mesh.metres_per_unit * mesh.positions[mesh.facets[k][c]];
      corners[c] = points->InsertNextPoint(p.data());
    }
    triangles->InsertNextCell(3, corners.data());
  }
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

// Fewer triangles that look alike; all of them where that fails.
vtkSmartPointer<vtkPolyData> decimated(vtkPolyData* facets, double kept) {
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputData(facets);
  welded->SetTolerance(0.0);
  vtkNew<vtkQuadricDecimation> fewer;
  fewer->SetInputConnection(welded->GetOutputPort());
  fewer->SetTargetReduction(1.0 - kept);
  fewer->Update();
  vtkSmartPointer<vtkPolyData> result = fewer->GetOutput();
  return result->GetNumberOfPolys() > 0 ? result : vtkSmartPointer<vtkPolyData>(facets);
}

Vec3 at(const ShownTarget& shown, std::uint32_t vertex) {
  const auto& p = shown.positions[vertex];
  return {p[0], p[1], p[2]};
}

// The facet that is nearest to a place.
class Nearest {
 public:
  explicit Nearest(vtkPolyData* facets) {
    locator_->SetDataSet(facets);
    locator_->BuildLocator();
  }
  [[nodiscard]] std::uint32_t to(const Vec3& place) const {
    std::array<double, 3> closest{};
    vtkIdType cell = 0;
    int sub = 0;
    double distance2 = 0.0;
    locator_->FindClosestPoint(place.data(), closest.data(), cell, sub, distance2);
    return static_cast<std::uint32_t>(std::max<vtkIdType>(0, cell));
  }

 private:
  vtkNew<vtkStaticCellLocator> locator_;
};

void add_part(ShownTarget& shown, const FacetMesh& mesh, std::uint32_t part, const std::vector<std::uint32_t>& facets,
              double kept) {
  const auto all = facets_of(mesh, facets);
  const auto few = decimated(all, kept);
  const auto first_vertex = static_cast<std::uint32_t>(shown.positions.size());
  const auto first_facet = static_cast<std::uint32_t>(shown.size());
  for (vtkIdType v = 0; v < few->GetNumberOfPoints(); ++v)
    shown.positions.push_back(rounded(Vec3(few->GetPoint(v)[0], few->GetPoint(v)[1], few->GetPoint(v)[2])));
  for (vtkIdType k = 0; k < few->GetNumberOfPolys(); ++k) {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    few->GetCellPoints(k, size, corners);
    shown.triangles.push_back({});
    for (std::size_t c = 0; c < 3; ++c)
      shown.triangles.back()[c] = first_vertex + static_cast<std::uint32_t>(corners[c]);
    shown.part.push_back(part);
  }
  shown.area.resize(shown.size(), 0.0);
  const Nearest nearest_shown(few), nearest(all);
  for (const std::uint32_t k : facets) {
    const auto corners = mesh.corners(k);
    shown.shown_of[k] =
        first_facet + nearest_shown.to(mesh.metres_per_unit / 3.0 * (corners[0] + corners[1] + corners[2]));
    shown.area[shown.shown_of[k]] += mesh.areas[k];
  }
  for (std::uint32_t k = first_facet; k < shown.size(); ++k) {
    const auto& [a, b, c] = shown.triangles[k];
    const Vec3 middle = (at(shown, a) + at(shown, b) + at(shown, c)) / 3.0;
    shown.value_of.push_back(shown.area[k] > 0.0 ? k : shown.shown_of[facets[nearest.to(middle)]]);
  }
}

}  // namespace

ShownTarget shown_target(const FacetMesh& mesh, std::size_t most) {
  if (mesh.size() <= most) return as_it_is(mesh);
  constexpr double fewest = 4.0;
  ShownTarget shown;
  shown.shown_of.resize(mesh.size());
  const auto facets_of = facets_of_parts(mesh);
  const double share = static_cast<double>(most) / static_cast<double>(mesh.size());
  for (std::uint32_t part = 0; part < facets_of.size(); ++part)
    if (!facets_of[part].empty())
      add_part(shown, mesh, part, facets_of[part],
               std::min(1.0, std::max(share, fewest / static_cast<double>(facets_of[part].size()))));
  return shown;
}

}  // namespace lrcs
