#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "base/vec3.h"
#include "lrcs/occluders.h"

namespace lrcs {

inline constexpr double unit_roundoff = 0x1p-53;

// A vertex in a facet's own coordinates: its projection along the view lies at t0 + u e1 + v e2, and its height over
// the facet's plane, toward the viewer.
struct FacetPoint {
  double u = 0.0, v = 0.0, height = 0.0;
  double error = 0.0;  // |height - true height| <= error; its sign is certain where error < |height|, or error == 0

  [[nodiscard]] bool sign_is_certain() const { return std::abs(height) > error || error == 0.0; }
};

// The point where a segment passes the facet's plane (height 0), for ends on either side of it.
[[nodiscard]] inline FacetPoint plane_passage(const FacetPoint& a, const FacetPoint& b) {
  const double t = a.height / (a.height - b.height);
  return {a.u + t * (b.u - a.u), a.v + t * (b.v - a.v), 0.0, 0.0};
}

// What the error of the two heights makes of that point's u and v.
[[nodiscard]] inline double passage_error(const FacetPoint& a, const FacetPoint& b) {
  const double length = std::abs(a.u - b.u) + std::abs(a.v - b.v);
  const double apart = std::abs(a.height - b.height);
  return (std::abs(a.height) / apart * b.error + std::abs(b.height) / apart * a.error) / apart * length;
}

// A facet's own coordinates along a viewing direction: the facet is the triangle u >= 0, v >= 0, u + v <= 1.
class FacetFrame {
 public:
  // How surely a viewer sees the facet edge-on: exactly, or as far as rounding can tell.
  enum class EdgeOn { no, perhaps, exactly };

  // domain of what follows turn(): a facet that is not seen edge-on.
  FacetFrame() = default;
  FacetFrame(const Occluders& occluders, std::uint32_t facet);

  [[nodiscard]] static EdgeOn edge_on(const Vec3& cross, const Vec3& direction);
  // Looks along a direction: unit vector toward the viewer.
  void turn(const Vec3& direction);
  // Looks along the facet's own normal: nothing knows u and v of places in its plane better, and there they are the
  // same whatever the direction.
  void turn_to_front() { turn(cross_ / cross_.stableNorm()); }

  // error: u, v: rounding(reach), reach as below. Exact at the facet's own corners.
  [[nodiscard]] FacetPoint at_vertex(std::uint32_t vertex) const;
  // What a step across the view is in u and v.
  [[nodiscard]] Eigen::Vector2d step(const Vec3& across) const { return {to_u_.dot(across), to_v_.dot(across)}; }
  // Makes the height right to one unit in the last place.
  void refine(FacetPoint& point, std::uint32_t vertex) const;
  // Where the edge from vertex `low` to vertex `high` > `low` passes the facet's plane (height 0), for ends on either
  // side of it; the vertex itself where both are the same. law: the same bits whoever asks, so that outlines that meet
  // there are joined. `error`: set to the error of u and v.
  [[nodiscard]] FacetPoint passage(std::uint32_t low, std::uint32_t high, double& error) const;
  // Which of the facet's corners the vertex is, 0..2; -1: none.
  [[nodiscard]] int corner(std::uint32_t vertex) const {
    return vertex == ids_[0] ? 0 : vertex == ids_[1] ? 1 : vertex == ids_[2] ? 2 : -1;
  }
  // Largest distance of the vertex from the first corner along an axis.
  [[nodiscard]] double reach(std::uint32_t vertex) const {
    return (occluders_->positions[vertex] - origin_).cwiseAbs().maxCoeff();
  }
  // Largest error of u and v of places within `reach`.
  [[nodiscard]] double rounding(double reach) const { return 8.0 * unit_roundoff * std::fmax(1.0, reach * stretch_); }
  // The relative error of the projection's scale.
  [[nodiscard]] double scale_error() const { return 8.0 * unit_roundoff * scale_; }
  [[nodiscard]] double own_reach() const { return std::fmax(e1_.cwiseAbs().maxCoeff(), e2_.cwiseAbs().maxCoeff()); }

  // +1: the front is seen, -1: the back.
  [[nodiscard]] double facing() const { return facing_; }

 private:
  const Occluders* occluders_ = nullptr;
  std::array<std::uint32_t, 3> ids_{};
  Vec3 origin_, e1_, e2_, cross_;
  Vec3 to_u_, to_v_;  // rows that give u and v
  double facing_ = 0.0;
  double stretch_ = 0.0;  // change of (u, v) per unit of length across the view, at most
  double scale_ = 0.0;    // relative error of the projection's scale, in units of 2^-53
};

}  // namespace lrcs
