#include "lrcs/facet_returns.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "lrcs/return_error.h"

namespace lrcs {
namespace {

// Even as large as the target it would be narrower than floats tell: what rays meet of it is chance.
constexpr double edge_on = 0x1p-30;

template <class Model>
std::function<double(const Vec3&)> function_of_normal(const Model& model, const Vec3& wi, const Vec3& wr) {
  if (wi == wr) return [model, w = wi](const Vec3& n) { return model.f_cos_cos_retro(n.dot(w)); };
  return [pair = model.for_pair(wi, wr)](const Vec3& n) { return pair(n); };
}

}  // namespace

void FacetReturns::look_along(const Vec3& to_transmitter, const Vec3& to_receiver) {
  wi_ = to_transmitter;
  wr_ = to_receiver;
  models_.clear();
  supposed_.clear();
  for (const Material& material : target_.materials)
    std::visit(
        [&](const auto& model) {
          models_.push_back(function_of_normal(model, wi_, wr_));
          supposed_.push_back(function_of_normal(supposed(model), wi_, wr_));
        },
        material.brdf);
}

double FacetReturns::value(const Models& models, std::size_t material, const Vec3& n) const {
  const double cos_r = n.dot(wr_);
  return cos_r > edge_on ? models[material](n) / cos_r : 0.0;
}

double FacetReturns::value(const Models& models, std::uint32_t facet) const {
  const Vec3& n = target_.mesh.normals[facet];
  if (n.dot(wr_) >= 0.0) return value(models, target_.material[facet], n);
  return target_.sides == Sides::front ? 0.0 : value(models, target_.back_material()[facet], -n);
}

double FacetReturns::of_material(std::size_t material, const Vec3& n) const {
  return value(supposed_, material, n);
}

double FacetReturns::of(std::uint32_t facet) const {
  return value(models_, facet);
}

double FacetReturns::most(std::uint32_t facet) const {
  const Vec3& n = target_.mesh.normals[facet];
  if (wi_ == wr_ || std::abs(n.dot(wi_)) > doubtful_cosine) return value(supposed_, facet);
  if (is_exactly_edge_on(n, wi_)) return 0.0;
  const double cos_r = std::abs(n.dot(wr_));
  if (cos_r <= edge_on) return 0.0;
  const double front = largest_edge_on(supposed_[target_.material[facet]], n, wi_, wr_);
  if (target_.sides == Sides::front) return front / cos_r;
  return std::max(front, largest_edge_on(supposed_[target_.back_material()[facet]], -n, wi_, wr_)) / cos_r;
}

double FacetReturns::range_in_plane_of(std::uint32_t facet) const {
  const Vec3& n = target_.mesh.normals[facet];
  const Vec3 toward = n.dot(wr_) >= 0.0 ? n : Vec3(-n);
  const double here = value(supposed_, facet);
  double range = target_.sides == Sides::front ? here : 0.0;
  for (std::size_t m = 0; m < models_.size(); ++m) range = std::max(range, std::abs(of_material(m, toward) - here));
  return range;
}

}  // namespace lrcs
