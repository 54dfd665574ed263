#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace lrcs {

// A picture, 8 bits a channel. shape: rgb has 3 width height bytes; rows from the bottom up, pixels from the left.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// Writes a PNG that appears whole or not at all; the same picture gives the same bytes.
// Throws std::runtime_error where writing fails.
void write_png(const std::filesystem::path& png, const Picture& picture);

// The picture made smaller by a whole factor: each pixel is the mean of factor x factor.
// domain: factor > 0 divides width and height.
[[nodiscard]] Picture shrunk(const Picture& picture, int factor);

}  // namespace lrcs
