#include "lrcs/facet_frame.h"

#include <algorithm>

#include "mesh/exact_height.h"

namespace lrcs {

FacetFrame::FacetFrame(const Occluders& occluders, std::uint32_t facet)
    : occluders_(&occluders),
      ids_(occluders.facets[facet]),
      origin_(occluders.positions[ids_[0]]),
      e1_(occluders.positions[ids_[1]] - origin_),
      e2_(occluders.positions[ids_[2]] - origin_),
      cross_(occluders.cross[facet]) {}

FacetFrame::EdgeOn FacetFrame::edge_on(const Vec3& cross, const Vec3& direction) {
  const Vec3 terms = cross.cwiseProduct(direction);
  if (terms.isZero(0.0)) return EdgeOn::exactly;
  // Five roundings of the product, and the direction's own.
  const double rounding = 8.0 * unit_roundoff * cross.lpNorm<1>();
  return std::abs(terms.sum()) <= rounding ? EdgeOn::perhaps : EdgeOn::no;
}

void FacetFrame::turn(const Vec3& direction) {
  const double facing = cross_.dot(direction);
  facing_ = facing > 0.0 ? 1.0 : -1.0;
  to_u_ = e2_.cross(direction) / facing;
  to_v_ = direction.cross(e1_) / facing;
  stretch_ = 2.0 * std::max(e1_.lpNorm<1>(), e2_.lpNorm<1>()) / std::abs(facing);
  scale_ = cross_.lpNorm<1>() / std::abs(facing);
}

FacetPoint FacetFrame::at_vertex(std::uint32_t vertex) const {
  constexpr std::array<FacetPoint, 3> corners{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
  if (const int k = corner(vertex); k >= 0) return corners[static_cast<std::size_t>(k)];
  const Vec3 x = occluders_->positions[vertex] - origin_;
  const Vec3 terms = x.cwiseProduct(cross_);
  // Of the height: four roundings each term (difference, normal (two units), product), then two sums.
  return {to_u_.dot(x), to_v_.dot(x), facing_ * terms.sum(), 8.0 * unit_roundoff * terms.lpNorm<1>()};
}

void FacetFrame::refine(FacetPoint& point, std::uint32_t vertex) const {
  if (point.error <= unit_roundoff * std::abs(point.height)) return;
  const auto& p = occluders_->positions;
  point.height = facing_ * exact_height(p[ids_[0]], p[ids_[1]], p[ids_[2]], p[vertex]);
  point.error = unit_roundoff * std::abs(point.height);
}

FacetPoint FacetFrame::passage(std::uint32_t low, std::uint32_t high, double& error) const {
  FacetPoint a = at_vertex(low), b = at_vertex(high);
  const double slack = rounding(std::max(reach(low), reach(high)));
  error = slack;
  if (low == high) return {a.u, a.v, 0.0, 0.0};
  // The signs first: they differ, and so do the heights.
  if (!a.sign_is_certain()) refine(a, low);
  if (!b.sign_is_certain()) refine(b, high);
  if (passage_error(a, b) > 64.0 * slack) {
    refine(a, low);
    refine(b, high);
  }
  error += passage_error(a, b);
  return plane_passage(a, b);
}

}  // namespace lrcs
