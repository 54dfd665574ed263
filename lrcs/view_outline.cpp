#include "lrcs/view_outline.h"

#include <algorithm>
#include <cmath>

#include "base/wide_loop.h"
#include "lrcs/facet_frame.h"

namespace lrcs {
namespace {

LRCS_WIDE void project(std::size_t count, const double* x, const double* y, const double* z, double a, double b,
                       double c, double* out) {
  for (std::size_t k = 0; k < count; ++k) out[k] = x[k] * a + y[k] * b + z[k] * c;
}

}  // namespace

void ViewOutline::look_along(const Vec3& toward) {
  frame_ = ViewFrame(toward, surface_->occluders.centre);
  const std::size_t vertices = surface_->x.size();
  const auto along = [&](const Vec3& axis, std::vector<double>& out) {
    out.resize(vertices);
    project(vertices, surface_->x.data(), surface_->y.data(), surface_->z.data(), axis.x(), axis.y(), axis.z(),
            out.data());
  };
  along(frame_.across, x_);
  along(frame_.up, y_);
  along(frame_.toward, z_);
  // The centre's subtraction, three products and their sum, of lengths up to the reach: below 16 roundings.
  rounding_ = 16.0 * unit_roundoff * surface_->tree.reach();
  face_facets();
  find_edges();
}

void ViewOutline::face_facets() {
  const auto& cross = surface_->occluders.cross;
  facing_.resize(cross.size());
  counted_.resize(cross.size() + 1);
  const Vec3& d = frame_.toward;
  doubtful_ = false;
  for (std::size_t f = 0; f < cross.size(); ++f) {
    const double along = cross[f].x() * d.x() + cross[f].y() * d.y() + cross[f].z() * d.z();
    // As FacetFrame::edge_on().
    const double doubt =
        8.0 * unit_roundoff * (std::abs(cross[f].x()) + std::abs(cross[f].y()) + std::abs(cross[f].z()));
    const int facing = (along > doubt ? 1 : 0) - (along < -doubt ? 1 : 0);
    facing_[f] = static_cast<std::int8_t>(facing);
    if (facing == 0 && FacetFrame::edge_on(cross[f], d) == FacetFrame::EdgeOn::perhaps) doubtful_ = true;
    counted_[f] = static_cast<std::int8_t>(facing < 0 && surface_->of_solid[f] != 0 ? 0 : facing);
  }
  counted_[cross.size()] = 0;
}

void ViewOutline::find_edges() {
  const auto& edges = surface_->edges.edges();
  edges_.clear();
  // A facet whose winding rises along the edge lies left of it where its front is seen.
  const auto on_right = [this](std::uint32_t use) {
    const int counted = counts(use / 2);
    return use % 2 != 0 ? -counted : counted;
  };
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const int first = on_right(edges[e].use[0]), second = on_right(edges[e].use[1]);
    if (first + second != 0) add_edge(e, first + second);
  }
  for (const std::uint32_t e : surface_->edges.crowded()) {
    int gain = 0;
    for (const FacetAtEdge& use : surface_->edges.facets_at(e)) gain += on_right(2 * use.facet + (use.rising ? 1 : 0));
    if (gain != 0) add_edge(e, gain);
  }
}

void ViewOutline::add_edge(std::uint32_t edge, int gain) {
  const auto& of_edge = surface_->edges.edges()[edge];
  const std::uint32_t low = of_edge.low, high = of_edge.high, none = 2 * static_cast<std::uint32_t>(facing_.size());
  OutlineBend bend;
  if (!surface_->occluders.corner_normals.empty() && of_edge.use[0] != none && of_edge.use[1] != none)
    bend = outline_bend(surface_->occluders, of_edge, frame_.toward);
  edges_.push_back({low, high, gain, Vec3(x_[low], y_[low], z_[low]), Vec3(x_[high], y_[high], z_[high]), bend});
}

}  // namespace lrcs
