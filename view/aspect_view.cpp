#include "view/aspect_view.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/direction.h"
#include "view/part_returns.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

std::string square_metres(double sigma_m2) {
  const std::string text = number_label(sigma_m2, 6) + " m²";
  return sigma_m2 > 0.0 ? text + " (" + tick_label(10.0 * std::log10(sigma_m2), 0.01) + " dBsm)" : text;
}

}  // namespace

AspectView::AspectView(const ViewedSweep& sweep, Compute compute, std::size_t row)
    : sweep_(sweep), compute_(std::move(compute)), scene_(*sweep.mesh) {
  go_to(row);
  scene_.look_beside(to_receiver());
}

Vec3 AspectView::to_receiver() const {
  return direction_of({result_.receiver_azimuth_deg, result_.receiver_elevation_deg});
}

void AspectView::go_to(std::size_t row) {
  if (row >= rows()) throw std::out_of_range("no such row of the sweep");
  row_ = row;
  result_ = compute_(row);
  part_sigma_ = part_returns(*sweep_.mesh, result_.sigma_m2);
  scene_.point_at(direction_of({result_.transmitter_azimuth_deg, result_.transmitter_elevation_deg}), to_receiver());
  if (follows_receiver_) scene_.look_from(to_receiver());
  colour();
}

void AspectView::show(const FacetShowing& showing) {
  showing_ = showing;
  colour();
}

void AspectView::colour() {
  ColouredFacets coloured = coloured_facets(*sweep_.mesh, result_, showing_);
  scene_.colour(coloured.colours, !coloured.scale.names.empty());
  scale_ = std::move(coloured.scale);
}

std::vector<std::string> AspectView::picked_lines() const {
  if (!part_) return {};
  const std::string& name = sweep_.mesh->part.names[*part_];
  const double sigma = part_sigma_[*part_];
  const double share = result_.sigma_total_m2 > 0.0 ? 100.0 * sigma / result_.sigma_total_m2 : 0.0;
  std::vector<std::string> lines{"part " + (name.empty() ? "(no name)" : name) + ": " + square_metres(sigma) + ", " +
                                 tick_label(share, 0.1) + " %"};
  if (!facet_) return lines;
  lines.push_back("facet " + std::to_string(*facet_) + ": " + square_metres(result_.sigma_m2[*facet_]) + ", area " +
                  number_label(sweep_.mesh->areas[*facet_], 4) + " m², seen " +
                  tick_label(100.0 * result_.seen_fraction[*facet_], 0.1) + " %, " +
                  result_.material_names[result_.material[*facet_]]);
  return lines;
}

std::vector<std::string> AspectView::pick_facet(std::optional<std::uint32_t> facet) {
  facet_ = facet;
  const auto before = part_;
  part_ = facet ? std::optional(sweep_.mesh->part.of[*facet]) : std::nullopt;
  if (part_ != before) scene_.outline_part(part_);
  return picked_lines();
}

std::vector<std::string> AspectView::pick_part(std::optional<std::uint32_t> part) {
  facet_.reset();
  part_ = part;
  scene_.outline_part(part);
  return picked_lines();
}

void AspectView::look_from_receiver(bool along) {
  follows_receiver_ = along;
  scene_.show_receiver(!along);
  if (along)
    scene_.look_from(to_receiver());
  else
    scene_.look_beside(to_receiver());
}

void AspectView::resize(int width, int height) {
  sheet_.emplace(sweep_, width, height);
  scene_.set_letters(sheet_->letters());
  const Box box = sheet_->target();
  scene_.fit((box.high.x - box.low.x) / (box.high.y - box.low.y));
}

Picture AspectView::paper(const std::string& keys) {
  return sheet_->drawn({row_, &result_, part_sigma_, scale_, part_, picked_lines(), keys});
}

Picture AspectView::picture(int width, int height) {
  resize(width, height);
  Canvas canvas(paper(""));
  const Box box = sheet_->target();
  canvas.paste(scene_.picture(static_cast<int>(box.high.x - box.low.x), static_cast<int>(box.high.y - box.low.y),
                              sheet_->letters()),
               static_cast<int>(box.low.x), static_cast<int>(box.low.y));
  return canvas.picture();
}

}  // namespace lrcs
