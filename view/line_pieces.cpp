#include "view/line_pieces.h"

#include <vtkBox.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "view/canvas.h"

namespace lrcs {
namespace {

class Pieces {
 public:
  explicit Pieces(const Box& box) : box_{box.low.x, box.high.x, box.low.y, box.high.y, 0.0, 0.0} {
    points_->SetDataTypeToDouble();
  }

  void add(const Point& from, const Point& to) {
    using Place = std::array<double, 3>;
    Place in{};
    Place out{};
    std::array<double, 2> t{};
    std::array<int, 2> plane{};
    const bool seen = vtkBox::IntersectWithLine(box_.data(), Place{from.x, from.y}.data(), Place{to.x, to.y}.data(),
                                                t[0], t[1], in.data(), out.data(), plane[0], plane[1]) != 0;
    if (seen) cut({in[0], in[1]}, {out[0], out[1]});
  }

  [[nodiscard]] vtkSmartPointer<vtkPolyData> data() const {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetLines(lines_);
    return data;
  }

 private:
  void cut(const Point& from, const Point& to) {
    constexpr double longest = 16.0;  // VTK visits every pixel of the box around a piece [pixel]
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!std::isfinite(length)) return;
    const double count = std::max(1.0, std::ceil(length / longest));
    for (double i = 0.0; i <= count; i += 1.0) {
      const double share = i / count;
      const auto point = points_->InsertNextPoint(std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share), 0.0);
      if (i > 0.0) lines_->InsertNextCell({point - 1, point});
    }
  }

  std::array<double, 6> box_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> lines_;
};

}  // namespace

vtkSmartPointer<vtkPolyData> line_pieces(const std::vector<std::vector<Point>>& lines, const Box& box) {
  Pieces pieces(box);
  for (const std::vector<Point>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) pieces.add(line[i > 0 ? i - 1 : 0], line[i]);
  }
  return pieces.data();
}

}  // namespace lrcs
