#include "view/png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string_view>

#include "base/whole_file.h"

namespace lrcs {
namespace {

std::size_t place(const Picture& picture, int column, int row) {
  return 3 *
         (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(column));
}

std::uint8_t mean_of_block(const Picture& picture, int column, int row, int factor, std::size_t channel) {
  unsigned sum = 0;
  for (int y = row * factor; y < (row + 1) * factor; ++y) {
    for (int x = column * factor; x < (column + 1) * factor; ++x) sum += picture.rgb[place(picture, x, y) + channel];
  }
  const auto count = static_cast<unsigned>(factor * factor);
  return static_cast<std::uint8_t>((sum + count / 2) / count);
}

}  // namespace

void write_png(const std::filesystem::path& png, const Picture& picture) {
  assert(picture.rgb.size() == place(picture, 0, picture.height));
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(picture.rgb.begin(), picture.rgb.end(), static_cast<std::uint8_t*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0) {
    throw std::runtime_error(png.string() + ": the picture cannot be encoded as PNG");
  }
  write_whole_file(png, std::string_view(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                                         static_cast<std::size_t>(bytes->GetNumberOfValues())));
}

Picture shrunk(const Picture& picture, int factor) {
  assert(factor > 0 && picture.width % factor == 0 && picture.height % factor == 0);
  Picture small{picture.width / factor, picture.height / factor, {}};
  small.rgb.reserve(place(small, 0, small.height));
  for (int row = 0; row < small.height; ++row) {
    for (int column = 0; column < small.width; ++column) {
      for (std::size_t c = 0; c < 3; ++c) small.rgb.push_back(mean_of_block(picture, column, row, factor, c));
    }
  }
  return small;
}

}  // namespace lrcs
