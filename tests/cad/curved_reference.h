#pragma once
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "base/vec3.h"
#include "brdf/brdf.h"

namespace lrcs {

// A surface by two parameters, u once round, whose area vector X_u x X_v is (a cos u, b sin u, c) at every v: surfaces
// of revolution about z, and ellipsoids.
struct RoundSurface {
  double v0, v1;
  std::function<Vec3(double v)> abc;
  std::vector<std::pair<Vec3, double>> flat;  // and flat faces: normal, area [m^2]
};

// Where both cosines are above zero, in u at one v: arcs (from, to).
inline std::vector<std::pair<double, double>> lit_arcs(const Vec3& abc, const Vec3& wi, const Vec3& wr) {
  constexpr double turn = 2.0 * std::numbers::pi;
  std::vector<double> ends{0.0, turn};
  for (const Vec3& w : {wi, wr}) {
    const double x = abc.x() * w.x(), y = abc.y() * w.y(), c = abc.z() * w.z(), r = std::hypot(x, y);
    if (!(r > std::abs(c))) continue;
    const double middle = std::atan2(y, x), half = std::acos(-c / r);
    for (const double end : {middle - half, middle + half}) ends.push_back(std::fmod(end + 2.0 * turn, turn));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::pair<double, double>> arcs;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double u = 0.5 * (ends[k] + ends[k + 1]);
    const Vec3 n(abc.x() * std::cos(u), abc.y() * std::sin(u), abc.z());
    if (n.dot(wi) > 0.0 && n.dot(wr) > 0.0) arcs.emplace_back(ends[k], ends[k + 1]);
  }
  return arcs;
}

// The same, cut where the nine-parameter model has creases: where both cosines are equal, and where either direction's
// part along the surface is square to that of wi + wr.
inline std::vector<std::pair<double, double>> smooth_arcs(const Vec3& abc, const Vec3& wi, const Vec3& wr) {
  auto arcs = lit_arcs(abc, wi, wr);
  if (wi == wr) return arcs;
  const Vec3 s = wi + wr;
  const auto normal = [&](double u) { return Vec3(abc.x() * std::cos(u), abc.y() * std::sin(u), abc.z()); };
  const std::array<std::function<double(double)>, 3> creases{
      [&](double u) { return normal(u).dot(wi - wr); },
      [&](double u) { return normal(u).squaredNorm() * wi.dot(s) - normal(u).dot(wi) * normal(u).dot(s); },
      [&](double u) { return normal(u).squaredNorm() * wr.dot(s) - normal(u).dot(wr) * normal(u).dot(s); }};
  std::vector<std::pair<double, double>> smooth;
  for (const auto& [from, to] : arcs) {
    std::vector<double> ends{from, to};
    constexpr int steps = 60;
    const double step = (to - from) / steps;
    for (const auto& crease : creases)
      for (int k = 0; k < steps; ++k) {
        double low = from + k * step, high = low + step;
        const bool is_above = crease(low) > 0.0;
        if ((crease(high) > 0.0) == is_above) continue;
        for (int halving = 0; halving < 45; ++halving) {
          const double middle = 0.5 * (low + high);
          ((crease(middle) > 0.0) == is_above ? low : high) = middle;
        }
        ends.push_back(low);
      }
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) smooth.emplace_back(ends[k], ends[k + 1]);
  }
  return smooth;
}

// 4 pi times the integral of f_r cos_i cos_r over what faces both directions [m^2]. error: 1e-9 relative for smooth
// models.
inline double unshaded_sigma(const RoundSurface& surface, const Brdf& brdf, const Vec3& wi, const Vec3& wr) {
  return std::visit(
      [&](const auto& model) {
        const auto ring = [&](double v) {
          const Vec3 abc = surface.abc(v);
          double sum = 0.0;
          for (const auto& [from, to] : smooth_arcs(abc, wi, wr)) {
            const int pieces = 1 + static_cast<int>(4.0 * (to - from));
            const double step = (to - from) / pieces;
            for (int k = 0; k < pieces; ++k)
              sum += boost::math::quadrature::gauss<double, 15>::integrate(
                  [&](double u) {
                    const Vec3 n(abc.x() * std::cos(u), abc.y() * std::sin(u), abc.z());
                    const double area = n.norm();
                    return area > 0.0 ? model.f_cos_cos(wi, wr, Vec3(n / area)) * area : 0.0;
                  },
                  from + k * step, from + (k + 1) * step);
          }
          return sum;
        };
        // Apart, so that no crease of a few degrees is missed by all places of the first look.
        constexpr int bands = 16;
        const double band = (surface.v1 - surface.v0) / bands;
        double sum = 0.0;
        for (int k = 0; k < bands; ++k)
          sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(ring, surface.v0 + k * band,
                                                                               surface.v0 + (k + 1) * band, 8, 1e-9);
        for (const auto& [normal, area] : surface.flat)
          if (normal.dot(wi) > 0.0 && normal.dot(wr) > 0.0) sum += area * model.f_cos_cos(wi, wr, normal);
        return 4.0 * std::numbers::pi * sum;
      },
      brdf);
}

// By its half axes.
inline RoundSurface ellipsoid_surface(double a, double b, double c) {
  return {
      -std::numbers::pi / 2,
      std::numbers::pi / 2,
      [=](double v) { return Vec3(std::cos(v) * Vec3(b * c * std::cos(v), a * c * std::cos(v), a * b * std::sin(v))); },
      {}};
}

// About z.
inline RoundSurface torus_surface(double ring, double tube) {
  return {
      0.0,
      2 * std::numbers::pi,
      [=](double v) { return Vec3(tube * (ring + tube * std::cos(v)) * Vec3(std::cos(v), std::cos(v), std::sin(v))); },
      {}};
}

// A torus about z that shades itself, monostatic: where the line of sight from a place meets it again, a cubic tells.
class ShadedTorus {
 public:
  ShadedTorus(double ring, double tube) : ring_(ring), tube_(tube) {}

  // error: 1e-7 relative.
  [[nodiscard]] double sigma(const Brdf& brdf, const Vec3& w) const {
    return std::visit(
        [&](const auto& model) {
          const auto slice = [&](double u) {
            double sum = 0.0;
            for (const auto& [from, to] : seen(u, w)) {
              constexpr int pieces = 8;
              const double step = (to - from) / pieces;
              for (int k = 0; k < pieces; ++k)
                sum += boost::math::quadrature::gauss<double, 15>::integrate(
                    [&](double v) {
                      return model.f_cos_cos(w, w, normal(u, v)) * tube_ * (ring_ + tube_ * std::cos(v));
                    },
                    from + k * step, from + (k + 1) * step);
            }
            return sum;
          };
          constexpr int sectors = 16;  // round from where the view comes, so that no tangent is missed by symmetry
          double sum = 0.0;
          for (int k = 0; k < sectors; ++k)
            sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                slice, 2.0 * std::numbers::pi * k / sectors, 2.0 * std::numbers::pi * (k + 1) / sectors, 8, 1e-7);
          return 4.0 * std::numbers::pi * sum;
        },
        brdf);
  }

 private:
  static Vec3 normal(double u, double v) { return {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)}; }

  // Above zero where the place is seen.
  [[nodiscard]] double clearance(double u, double v, const Vec3& w) const {
    const Vec3 n = normal(u, v);
    const double facing = n.dot(w);
    if (facing <= 0.0) return facing;
    const Vec3 p = ring_ * Vec3(std::cos(u), std::sin(u), 0.0) + tube_ * n;
    const double alpha = p.squaredNorm() + ring_ * ring_ - tube_ * tube_, beta = p.dot(w);
    const double flat = p.x() * w.x() + p.y() * w.y(), w2 = w.x() * w.x() + w.y() * w.y(), r2 = ring_ * ring_;
    // The quartic of the distance along the line of sight, less the place itself: t^3 + a t^2 + b t + c.
    const double a = 4.0 * beta, b = 4.0 * beta * beta + 2.0 * alpha - 4.0 * r2 * w2;
    const double c = 4.0 * alpha * beta - 8.0 * r2 * flat, root = a * a - 3.0 * b;
    if (root <= 0.0) return 1.0;
    const double t = (-a + std::sqrt(root)) / 3.0;
    return t > 0.0 ? ((t + a) * t + b) * t + c : 1.0;
  }

  [[nodiscard]] std::vector<std::pair<double, double>> seen(double u, const Vec3& w) const {
    constexpr int steps = 200;
    std::vector<std::pair<double, double>> arcs;
    const auto place = [&](int k) { return 2.0 * std::numbers::pi * (k + 0.5) / steps; };
    double from = place(0);
    bool is_seen = clearance(u, from, w) > 0.0;
    for (int k = 0; k < steps; ++k) {
      const double here = place(k), next = place(k + 1);
      const bool next_is_seen = clearance(u, next, w) > 0.0;
      if (next_is_seen == is_seen) continue;
      double low = here, high = next;
      for (int half = 0; half < 50; ++half) {
        const double middle = 0.5 * (low + high);
        ((clearance(u, middle, w) > 0.0) == is_seen ? low : high) = middle;
      }
      if (is_seen) arcs.emplace_back(from, low);
      from = high;
      is_seen = next_is_seen;
    }
    if (is_seen) arcs.emplace_back(from, place(steps));
    return arcs;
  }

  double ring_, tube_;
};

}  // namespace lrcs
