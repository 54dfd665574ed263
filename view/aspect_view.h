#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "view/aspect_sheet.h"
#include "view/facet_colours.h"
#include "view/facet_result.h"
#include "view/target_scene.h"
#include "view/viewed_sweep.h"

namespace lrcs {

// What `lrcs view` shows: a target coloured by what its facets return at one row of a sweep, and what is to be read
// beside it; in a window or as a picture.
class AspectView {
 public:
  // The facets' result at a row of the sweep; asked for each row that is shown.
  using Compute = std::function<FacetResult(std::size_t row)>;

  // row: to begin with. domain: one of the sweep, else std::out_of_range.
  AspectView(const ViewedSweep& sweep, Compute compute, std::size_t row = 0);

  // domain: a row of the sweep, else std::out_of_range.
  void go_to(std::size_t row);
  [[nodiscard]] std::size_t row() const { return row_; }
  [[nodiscard]] std::size_t rows() const { return sweep_.places.size(); }
  [[nodiscard]] const FacetResult& result() const { return result_; }
  [[nodiscard]] const std::vector<double>& part_sigma() const { return part_sigma_; }

  void show(const FacetShowing& showing);
  [[nodiscard]] const FacetShowing& showing() const { return showing_; }

  // Looks at a facet and its part, at a part, or at none. Value: what there is to read of it, in lines.
  std::vector<std::string> pick_facet(std::optional<std::uint32_t> facet);
  std::vector<std::string> pick_part(std::optional<std::uint32_t> part);

  // From beside the receiver (to begin with), or from where the receiver stands, along with it.
  void look_from_receiver(bool along);

  void resize(int width, int height);
  [[nodiscard]] const AspectSheet& sheet() const { return *sheet_; }
  [[nodiscard]] TargetScene& scene() { return scene_; }
  // The sheet without the target. keys: a line on what may be done.
  [[nodiscard]] Picture paper(const std::string& keys);
  // All of it, drawn without a window. error: std::runtime_error where no 3-D picture can be drawn.
  [[nodiscard]] Picture picture(int width, int height);

 private:
  void colour();
  [[nodiscard]] Vec3 to_receiver() const;
  [[nodiscard]] std::vector<std::string> picked_lines() const;

  const ViewedSweep& sweep_;
  Compute compute_;
  TargetScene scene_;
  std::optional<AspectSheet> sheet_;
  FacetShowing showing_;
  std::size_t row_ = 0;
  FacetResult result_;
  std::vector<double> part_sigma_;
  ColourScale scale_;
  std::optional<std::uint32_t> facet_, part_;
  bool follows_receiver_ = false;
};

}  // namespace lrcs
