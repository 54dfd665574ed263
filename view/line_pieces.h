#pragma once
#include <vector>

class vtkPolyData;
template <class T>
class vtkSmartPointer;

namespace lrcs {

struct Box;
struct Point;

// What of some lines lies in a box, in short straight pieces, for VTK.
// domain: a line of one point gives a piece of no length; what is not finite gives none.
[[nodiscard]] vtkSmartPointer<vtkPolyData> line_pieces(const std::vector<std::vector<Point>>& lines, const Box& box);

}  // namespace lrcs
