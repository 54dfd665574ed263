#include "view/offscreen.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "view/private_display.h"
#include "view/vtk_errors.h"

namespace lrcs {
namespace {

Picture pixels_of(vtkRenderWindow* window, int width, int height) {
  vtkNew<vtkUnsignedCharArray> rgb;
  const int got = window->GetPixelData(0, 0, width - 1, height - 1, 0, rgb.Get());
  const auto bytes = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (got == 0 || static_cast<std::size_t>(rgb->GetNumberOfValues()) != bytes) {
    throw std::runtime_error("the 3-D picture cannot be drawn: OpenGL gave no pixels");
  }
  return {width, height, {rgb->GetPointer(0), rgb->GetPointer(0) + bytes}};
}

}  // namespace

Picture drawn_offscreen(const std::vector<vtkRenderer*>& layers, int width, int height) {
  std::string why;
  const auto display = PrivateDisplay::open(&why);
  if (!display) throw std::runtime_error("3-D pictures cannot be drawn here: " + why);
  const VtkErrors errors;
  vtkNew<vtkRenderWindow> window;
  window->SetDisplayId(display->connection());
  window->SetMultiSamples(0);
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetSize(width, height);
  window->SetNumberOfLayers(static_cast<int>(layers.size()));
  for (vtkRenderer* layer : layers) window->AddRenderer(layer);
  window->Render();
  Picture picture = pixels_of(window, width, height);
  if (errors.any()) throw std::runtime_error("the 3-D picture cannot be drawn: " + errors.first());
  if (display->failed()) throw std::runtime_error("the 3-D picture cannot be drawn: the X server failed");
  for (vtkRenderer* layer : layers) window->RemoveRenderer(layer);
  return picture;
}

int offscreen_fineness(int width, int height) {
  constexpr int largest = 8192;  // what every driver takes
  return std::clamp(largest / std::max(width, height), 1, 3);
}

}  // namespace lrcs
