#include "view/dashes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "view/canvas.h"

namespace lrcs {
namespace {

// Walks along a line, laying ink and gap in turn.
class Dasher {
 public:
  explicit Dasher(const std::vector<double>& dash) : dash_(dash), left_(dash.front()) {}

  void start(const Point& at) { strokes_.push_back({at}); }

  void walk(const Point& from, const Point& to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    double walked = 0.0;
    while (length - walked > left_) {
      walked += left_;
      turn({std::lerp(from.x, to.x, walked / length), std::lerp(from.y, to.y, walked / length)});
    }
    left_ -= length - walked;
    if (inked()) strokes_.back().push_back(to);
  }

  [[nodiscard]] std::vector<std::vector<Point>> strokes() const { return strokes_; }

 private:
  [[nodiscard]] bool inked() const { return phase_ % 2 == 0; }

  void turn(const Point& at) {
    if (inked()) strokes_.back().push_back(at);
    phase_ = (phase_ + 1) % dash_.size();
    left_ = dash_[phase_];
    if (inked()) start(at);
  }

  const std::vector<double>& dash_;
  double left_;
  std::size_t phase_ = 0;
  std::vector<std::vector<Point>> strokes_;
};

}  // namespace

std::vector<std::vector<Point>> dashes(const std::vector<Point>& line, const std::vector<double>& dash) {
  if (line.empty() || dash.empty()) return {line};
  if (dash.size() % 2 != 0 || !std::all_of(dash.begin(), dash.end(), [](double length) { return length > 0.0; })) {
    throw std::invalid_argument("a dash pattern is an even number of lengths above zero");
  }
  Dasher dasher(dash);
  dasher.start(line.front());
  for (std::size_t i = 1; i < line.size(); ++i) dasher.walk(line[i - 1], line[i]);
  return dasher.strokes();
}

}  // namespace lrcs
