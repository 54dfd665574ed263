#pragma once
#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/scratch_folder.h"
#include "view/colour.h"

namespace lrcs {

// A PNG as read back from disk by VTK: rows from the bottom up.
struct PngPixels {
  explicit PngPixels(const std::filesystem::path& png) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(png.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    image->GetDimensions(size.data());
    const auto* first = static_cast<const std::uint8_t*>(image->GetScalarPointer());
    rgb.assign(first, first + 3 * size[0] * size[1]);
  }

  [[nodiscard]] bool is(const Colour& colour, int column, int row, int tolerance = 2) const {
    const std::size_t pixel = 3 * static_cast<std::size_t>(row * size[0] + column);
    return std::abs(rgb[pixel] - 255.0 * colour.red) <= tolerance &&
           std::abs(rgb[pixel + 1] - 255.0 * colour.green) <= tolerance &&
           std::abs(rgb[pixel + 2] - 255.0 * colour.blue) <= tolerance;
  }

  std::array<int, 3> size{};
  std::vector<std::uint8_t> rgb;
};

// The box that the pixels of a colour fill, and their number and centre. Columns and rows from the lower left.
struct Found {
  int left = 1 << 30;
  int right = -1;
  int bottom = 1 << 30;
  int top = -1;
  int count = 0;
  double column = 0.0;
  double row = 0.0;
};

inline Found find_colour(const PngPixels& pixels, const Colour& colour, int tolerance = 2) {
  Found found;
  for (int row = 0; row < pixels.size[1]; ++row) {
    for (int column = 0; column < pixels.size[0]; ++column) {
      if (!pixels.is(colour, column, row, tolerance)) continue;
      found.left = std::min(found.left, column);
      found.right = std::max(found.right, column);
      found.bottom = std::min(found.bottom, row);
      found.top = std::max(found.top, row);
      ++found.count;
      found.column += column + 0.5;
      found.row += row + 0.5;
    }
  }
  if (found.count > 0) {
    found.column /= found.count;
    found.row /= found.count;
  }
  return found;
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A file name of this test's own, with nothing there.
inline std::filesystem::path scratch_file(const std::string& name) {
  static const ScratchFolder scratch;
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = scratch.path() / (std::string(test->test_suite_name()) + "-" + test->name());
  std::filesystem::create_directories(folder);
  std::filesystem::remove(folder / name);
  return folder / name;
}

// For EXPECT_EXIT: the child is this program started afresh, for a fork of one with threads may not draw.
inline void exit_in_fresh_process() {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
}

}  // namespace lrcs
