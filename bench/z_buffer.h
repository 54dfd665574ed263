#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "bench/pixel_grid.h"
#include "view/private_display.h"

namespace lrcs {

// The target drawn by OpenGL, each facet in a colour of its own, and the pixels counted that each one has in the end.
// One thread where OpenGL is llvmpipe.
class ZBuffer {
 public:
  // Keeps references. A window for each number of pixels along its sides is opened and drawn once.
  // error: std::runtime_error where OpenGL cannot draw.
  ZBuffer(const FacetMesh& mesh, const PixelGrids& grids, const PrivateDisplay& display,
          const std::vector<std::uint32_t>& sizes);
  ~ZBuffer();
  ZBuffer(const ZBuffer&) = delete;
  ZBuffer& operator=(const ZBuffer&) = delete;

  // domain: pixels: one of the sizes.
  void draw(const Vec3& to_viewer, std::uint32_t pixels);

  // Of the last drawing. shape: one a facet; 0 for those that turn their back.
  [[nodiscard]] std::vector<double> seen_fraction() const;

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
};

// Xvfb with software OpenGL on one thread; null, and *why_not set, where there is none. Opened once in a process.
[[nodiscard]] std::unique_ptr<PrivateDisplay> open_z_buffer_display(std::string* why_not);

}  // namespace lrcs
