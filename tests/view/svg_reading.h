#pragma once
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "view/canvas.h"

namespace lrcs {

// An SVG file read back as XML; places are turned into the canvas' frame (y up).
class SvgReading {
 public:
  explicit SvgReading(const std::string& text)
      : root_(vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(text.c_str()))) {
    if (root_ == nullptr) throw std::runtime_error("not well-formed XML");
    height_ = std::stod(attribute(root_, "height"));
  }

  [[nodiscard]] vtkXMLDataElement* root() const { return root_; }

  // Everywhere in the file, in its order.
  [[nodiscard]] std::vector<vtkXMLDataElement*> named(const std::string& name) const {
    std::vector<vtkXMLDataElement*> found;
    collect(root_, name, found);
    return found;
  }
  // Of those the ones with that value of an attribute.
  [[nodiscard]] std::vector<vtkXMLDataElement*> named(const std::string& name, const std::string& key,
                                                      const std::string& value) const {
    std::vector<vtkXMLDataElement*> found;
    for (vtkXMLDataElement* element : named(name))
      if (attribute(element, key) == value) found.push_back(element);
    return found;
  }
  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> words;
    for (vtkXMLDataElement* element : named("text")) words.emplace_back(element->GetCharacterData());
    return words;
  }

  // "" where there is none.
  [[nodiscard]] static std::string attribute(vtkXMLDataElement* element, const std::string& key) {
    const char* value = element->GetAttribute(key.c_str());
    return value == nullptr ? "" : value;
  }
  [[nodiscard]] static double number(vtkXMLDataElement* element, const std::string& key) {
    return std::stod(attribute(element, key));
  }
  // Of a polygon or a path.
  [[nodiscard]] std::vector<Point> points(vtkXMLDataElement* element) const {
    std::string words = attribute(element, "points") + attribute(element, "d");
    for (char& c : words)
      if (c == 'M' || c == ',') c = ' ';
    std::vector<double> numbers;
    const char* at = words.c_str();
    for (char* end = nullptr;; at = end) {
      const double value = std::strtod(at, &end);
      if (end == at) break;
      numbers.push_back(value);
    }
    std::vector<Point> points;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) points.push_back({numbers[i], height_ - numbers[i + 1]});
    return points;
  }

 private:
  static void collect(vtkXMLDataElement* element, const std::string& name, std::vector<vtkXMLDataElement*>& found) {
    if (name == element->GetName()) found.push_back(element);
    for (int k = 0; k < element->GetNumberOfNestedElements(); ++k) collect(element->GetNestedElement(k), name, found);
  }

  vtkSmartPointer<vtkXMLDataElement> root_;
  double height_ = 0.0;
};

inline SvgReading read_back(const Canvas& canvas) {
  return SvgReading(canvas.svg());
}

// As SVG writes it.
inline std::string hex_of(const Colour& colour) {
  const Rgb rgb = rgb_of(colour);
  std::string text = "#";
  for (const std::uint8_t byte : rgb) {
    text += "0123456789abcdef"[byte / 16];
    text += "0123456789abcdef"[byte % 16];
  }
  return text;
}

}  // namespace lrcs
