#include "view/png.h"

#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <cassert>
#include <stdexcept>

#include "base/whole_file.h"

namespace lrcs {
namespace {

std::size_t bytes_of(const Picture& picture) {
  return 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

// For reading only.
vtkSmartPointer<vtkImageData> image_of(const Picture& picture) {
  assert(picture.rgb.size() == bytes_of(picture));
  return image_on(const_cast<std::uint8_t*>(picture.rgb.data()), picture.width, picture.height, 3);
}

}  // namespace

vtkSmartPointer<vtkImageData> image_on(std::uint8_t* bytes, int width, int height, int channels) {
  constexpr int stay_the_callers = 1;
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfComponents(channels);
  array->SetArray(bytes, static_cast<vtkIdType>(channels) * width * height, stay_the_callers);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(array);
  return image;
}

std::string png_bytes(const Picture& picture) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image_of(picture));
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0)
    throw std::runtime_error("the picture cannot be encoded as PNG");
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

void write_png(const std::filesystem::path& png, const Picture& picture) {
  write_whole_file(png, png_bytes(picture));
}

Picture shrunk(const Picture& picture, int factor) {
  assert(factor > 0 && picture.width % factor == 0 && picture.height % factor == 0);
  vtkNew<vtkImageShrink3D> mean;
  mean->SetInputData(image_of(picture));
  mean->SetShrinkFactors(factor, factor, 1);
  mean->Update();
  Picture small{picture.width / factor, picture.height / factor, {}};
  const auto* first = static_cast<const std::uint8_t*>(mean->GetOutput()->GetScalarPointer());
  small.rgb.assign(first, first + bytes_of(small));
  return small;
}

}  // namespace lrcs
