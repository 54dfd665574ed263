#include "view/text_bitmap.h"

// VTK 9.1 deprecates the overloads with vtkUnicodeString, but those with vtkStdString lose every letter outside ASCII.
#define VTK_DEPRECATION_LEVEL 0
#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtkUnicodeString.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace lrcs {
namespace {

void apply(const Font& font, vtkTextProperty* property) {
  property->SetFontFamilyToArial();
  property->SetFontSize(font.size);
  property->SetBold(font.bold ? 1 : 0);
  property->SetColor(1.0, 1.0, 1.0);
  property->SetJustificationToLeft();
  property->SetVerticalJustificationToBottom();
}

TextBitmap letters(const std::string& text, const Font& font) {
  constexpr int pixels_per_inch = 72;  // one point is one pixel
  vtkNew<vtkTextProperty> property;
  apply(font, property);
  vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
  tools->ScaleToPowerTwoOff();
  vtkNew<vtkImageData> image;
  if (!tools->RenderString(property, vtkUnicodeString::from_utf8(text), pixels_per_inch, image.Get())) {
    throw std::runtime_error("the text '" + text + "' cannot be drawn");
  }
  std::array<int, 6> extent{};
  image->GetExtent(extent.data());
  TextBitmap bitmap{extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, 0, 0, {}};
  const auto* texels = static_cast<const std::uint8_t*>(image->GetScalarPointer());
  for (vtkIdType texel = 0; texel < image->GetNumberOfPoints(); ++texel) {
    bitmap.coverage.push_back(texels[4 * texel + 3]);
  }
  return bitmap;
}

int rows_below_ink(const TextBitmap& bitmap) {
  const auto inked = std::find_if(bitmap.coverage.begin(), bitmap.coverage.end(),
                                  [](std::uint8_t coverage) { return coverage > 127; });
  return bitmap.width > 0 ? static_cast<int>(inked - bitmap.coverage.begin()) / bitmap.width : 0;
}

}  // namespace

TextBitmap text_bitmap(const std::string& text, const Font& font) {
  if (text.empty()) return {};
  TextBitmap bitmap = letters(text, font);
  const TextBitmap capital = letters("H", font);
  bitmap.baseline = rows_below_ink(capital);
  bitmap.capital = capital.height - bitmap.baseline;
  return bitmap;
}

}  // namespace lrcs
