#include "bench/z_buffer.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "view/vtk_errors.h"

namespace lrcs {
namespace {

constexpr std::uint32_t nothing = 0xffffffU;  // the ground's number: white

vtkSmartPointer<vtkPolyData> triangles(const FacetMesh& mesh, const Placement& placement) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (const Vec3& p : mesh.positions) {
    const Vec3 q = placement.placed(p);
    points->InsertNextPoint(q.x(), q.y(), q.z());
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (std::uint32_t f = 0; f < mesh.size(); ++f) {
    cells->InsertNextCell({mesh.facets[f][0], mesh.facets[f][1], mesh.facets[f][2]});
    const std::array<std::uint8_t, 3> number{static_cast<std::uint8_t>(f >> 16U), static_cast<std::uint8_t>(f >> 8U),
                                             static_cast<std::uint8_t>(f)};
    colours->InsertNextTypedTuple(number.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(colours);
  return data;
}

// A window's worth of the target.
class Sheet {
 public:
  Sheet(vtkPolyData* target, const PrivateDisplay& display, std::uint32_t pixels) : pixels_(pixels) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(target);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    renderer_->AddActor(actor);
    renderer_->SetBackground(1.0, 1.0, 1.0);
    window_->SetDisplayId(display.connection());
    window_->SetMultiSamples(0);
    window_->SetShowWindow(false);
    window_->SetUseOffScreenBuffers(true);
    window_->SetSize(static_cast<int>(pixels), static_cast<int>(pixels));
    window_->AddRenderer(renderer_);
  }

  // The numbers of the facets, four bytes a pixel.
  vtkUnsignedCharArray* drawn(const PixelGrid& grid) {
    look_at(grid);
    window_->Render();
    window_->GetRGBACharPixelData(0, 0, static_cast<int>(grid.columns) - 1, static_cast<int>(grid.rows) - 1, 0,
                                  numbers_.Get());
    return numbers_;
  }

 private:
  void look_at(const PixelGrid& grid) {
    constexpr double margin = 0.1;
    const double half = 0.5 * grid.pixel * pixels_;
    const Vec3 middle = grid.corner + half * (grid.right + grid.up);
    const Vec3 eye = middle + 2.0 * margin * grid.toward;
    vtkCamera* camera = renderer_->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(half);
    camera->SetFocalPoint(middle.x(), middle.y(), middle.z());
    camera->SetPosition(eye.x(), eye.y(), eye.z());
    camera->SetViewUp(grid.up.x(), grid.up.y(), grid.up.z());
    camera->SetClippingRange(margin, 3.0 * margin + grid.depth);
  }

  std::uint32_t pixels_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkUnsignedCharArray> numbers_;
};

}  // namespace

struct ZBuffer::Hidden {
  const FacetMesh& mesh;
  const PixelGrids& grids;
  const PrivateDisplay& display;
  VtkErrors errors;
  std::map<std::uint32_t, Sheet> sheets;
  PixelGrid grid;
  std::vector<std::uint32_t> pixels;  // of each facet
};

ZBuffer::ZBuffer(const FacetMesh& mesh, const PixelGrids& grids, const PrivateDisplay& display,
                 const std::vector<std::uint32_t>& sizes)
    : hidden_(new Hidden{mesh, grids, display, {}, {}, {}, std::vector<std::uint32_t>(mesh.size())}) {
  if (mesh.size() > nothing) throw std::runtime_error("more facets than colours");
  const auto target = triangles(mesh, grids.placement());
  for (const std::uint32_t size : sizes) {
    hidden_->sheets.try_emplace(size, target, display, size);
    draw(Vec3::UnitX(), size);
  }
}

ZBuffer::~ZBuffer() = default;

void ZBuffer::draw(const Vec3& to_viewer, std::uint32_t pixels) {
  Hidden& h = *hidden_;
  std::fill(h.pixels.begin(), h.pixels.end(), 0U);
  h.grid = h.grids.over(to_viewer, pixels);
  vtkUnsignedCharArray* numbers = h.sheets.at(pixels).drawn(h.grid);
  const std::size_t count = std::size_t{h.grid.columns} * h.grid.rows;
  if (h.errors.any() || h.display.failed() || static_cast<std::size_t>(numbers->GetNumberOfValues()) != 4 * count)
    throw std::runtime_error("OpenGL cannot draw: " + h.errors.first());
  const std::uint8_t* rgba = numbers->GetPointer(0);
  for (std::size_t k = 0; k < count; ++k, rgba += 4) {
    const std::uint32_t facet = std::uint32_t{rgba[0]} << 16U | std::uint32_t{rgba[1]} << 8U | std::uint32_t{rgba[2]};
    if (facet < h.pixels.size()) ++h.pixels[facet];
  }
}

std::vector<double> ZBuffer::seen_fraction() const {
  const double side = hidden_->grid.pixel / hidden_->grids.placement().scale;
  return lrcs::seen_fraction(hidden_->mesh, hidden_->pixels, side * side, hidden_->grid.toward);
}

std::unique_ptr<PrivateDisplay> open_z_buffer_display(std::string* why_not) {
  setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe draws in the thread that asks
  return PrivateDisplay::open(why_not);
}

}  // namespace lrcs
