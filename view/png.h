#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

class vtkImageData;
template <class T>
class vtkSmartPointer;

namespace lrcs {

// A picture, 8 bits a channel. shape: rgb has 3 width height bytes; rows from the bottom up, pixels from the left.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// Bytes as VTK's picture, without a copy: VTK reads and writes them in place, as long as they live.
// shape: rows from the bottom up, `channels` bytes a pixel.
[[nodiscard]] vtkSmartPointer<vtkImageData> image_on(std::uint8_t* bytes, int width, int height, int channels);

// The picture as a PNG file; the same picture gives the same bytes.
[[nodiscard]] std::string png_bytes(const Picture& picture);

// Writes a PNG that appears whole or not at all; the same picture gives the same bytes.
// Throws std::runtime_error where writing fails.
void write_png(const std::filesystem::path& png, const Picture& picture);

// The picture made smaller by a whole factor: each pixel is the mean of factor x factor. error: 1 level, downward.
// domain: factor > 0 divides width and height.
[[nodiscard]] Picture shrunk(const Picture& picture, int factor);

}  // namespace lrcs
