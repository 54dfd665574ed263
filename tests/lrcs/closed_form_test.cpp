// Closed forms of physics (docs/methods.md, section 4), each to its discretisation error with the measured order.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/lrcs/test_targets.h"

namespace lrcs {
namespace {

using std::numbers::pi;

double sigma(FacetMesh mesh, const Brdf& brdf, const Vec3& di, const Vec3& dr) {
  return section_of(target_of(std::move(mesh), brdf), di, dr).sigma.value;
}

// The error falls with the order 2 of flat facets, and is small at the finest.
void expect_second_order(const std::function<double(std::uint32_t)>& computed, double truth, std::uint32_t coarse,
                         double largest_error) {
  const double first = std::abs(computed(coarse) / truth - 1.0), second = std::abs(computed(2 * coarse) / truth - 1.0);
  EXPECT_LT(second, largest_error);
  EXPECT_NEAR(std::log2(first / second), 2.0, 0.15);
}

FacetMesh cylinder_side(std::uint32_t sectors) {
  return revolved({{1.0, 0.0}, {1.0, 1.0}}, sectors);
}

// Half-angle 15 deg, base radius 1 at z = 0, no base.
FacetMesh cone(std::uint32_t sectors) {
  return revolved({{1.0, 0.0}, {0.0, 1.0 / std::tan(15.0 * degree)}}, sectors);
}

FacetMesh paraboloid(double p, double radius, std::uint32_t rings) {
  std::vector<std::pair<double, double>> profile;
  for (std::uint32_t k = 0; k <= rings; ++k) {
    const double r = radius * (1.0 - static_cast<double>(k) / rings);
    profile.emplace_back(r, -r * r / (2.0 * p));
  }
  return revolved(profile, 4 * rings);
}

Vec3 from_z(double angle) {
  return {std::sin(angle), 0.0, std::cos(angle)};
}

TEST(LambertPlate, IsExact) {
  FacetMesh plate;
  add_plate(plate, {0, 0, 0}, {2, 0, 0}, {0, 1.5, 0});
  for (const double t : {0.0, 0.3, 1.0, 1.5, 89.9999 * degree}) {
    const double truth = 4.0 * 0.7 * 3.0 * std::cos(t) * std::cos(t);
    EXPECT_NEAR(sigma(plate, lambert(0.7), from_z(t), from_z(t)), truth, 1e-13 * 12.0 * std::cos(t));
  }
}

TEST(LambertSphere, ConvergesAtSecondOrder) {
  const Vec3 d(0, 0, 1);
  expect_second_order([&](auto n) { return sigma(sphere(1.0, n), lambert(0.8), d, d); }, 8.0 / 3.0 * pi * 0.8, 20,
                      1e-2);
}

TEST(LambertSphere, ConvergesAtSecondOrderForBistaticAngles) {
  for (const double b : {0.5, 1.5, 2.5}) {
    const double truth = 8.0 / 3.0 * 0.8 * (std::sin(b) + (pi - b) * std::cos(b));
    const Vec3 di(0, 0, 1), dr = from_z(b);
    const double n20 = sigma(sphere(1.0, 20), lambert(0.8), di, dr), n80 = sigma(sphere(1.0, 80), lambert(0.8), di, dr);
    EXPECT_NEAR(n80 / truth, 1.0, 3e-3);
    EXPECT_NEAR(std::log2(std::abs(n20 / truth - 1.0) / std::abs(n80 / truth - 1.0)) / 2.0, 2.0, 0.35) << b;
  }
}

TEST(LambertCylinder, ConvergesAtSecondOrder) {
  for (const double psi : {0.4, 1.0, pi / 2}) {
    const double truth = 2.0 * pi * 0.6 * std::pow(std::sin(psi), 2);
    // The open end shows the inside; a disc as lid, seen from below or above, is left out by counting outward sides
    // only.
    expect_second_order(
        [&](auto n) {
          Target target = target_of(cylinder_side(n), lambert(0.6));
          target.sides = Sides::front;
          // A quarter of a sector: silhouettes on edges.
          const Vec3 d = Eigen::AngleAxisd(pi / n, Vec3::UnitZ()) * from_z(psi);
          return section_of(target, d, d).sigma.value;
        },
        truth, 24, 5e-3);
  }
}

TEST(LambertCone, ConvergesAtSecondOrder) {
  const double half = 15.0 * degree;
  for (const double t : {0.0, 0.1, 0.25}) {
    const double truth = 4.0 * pi * 0.9 / std::sin(half) *
                         (std::pow(std::sin(half) * std::cos(t), 2) + 0.5 * std::pow(std::cos(half) * std::sin(t), 2));
    expect_second_order([&](auto n) { return sigma(cone(n), lambert(0.9), from_z(t), from_z(t)); }, truth, 24, 8e-3);
  }
}

TEST(LambertParaboloid, ConvergesAtSecondOrderOnItsAxis) {
  const double p = 0.8, radius = 1.3;
  const double truth = 8.0 * pi * 0.5 * p * p * (std::sqrt(1.0 + std::pow(radius / p, 2)) - 1.0);
  const Vec3 d(0, 0, 1);
  expect_second_order([&](auto n) { return sigma(paraboloid(p, radius, n), lambert(0.5), d, d); }, truth, 16, 2e-3);
}

TEST(WuSphere, HasItsClosedFormWithoutShadowing) {
  WuParameters<double> parameters;
  parameters.kb = 0.117, parameters.kr = 1.901, parameters.b = -17.0, parameters.a = 0.9, parameters.kd = 0.045;
  parameters.sigma_p = 0.0;
  const double c = parameters.kr * parameters.kr - 1.0;
  const double truth =
      8.0 * pi * pi *
      (parameters.kb * parameters.kr * parameters.kr * (1.0 / c - std::log1p(c) / (c * c)) + parameters.kd / 2.0);
  const Vec3 d(0, 0, 1);
  expect_second_order([&](auto n) { return sigma(sphere(1.0, n), Wu(parameters), d, d); }, truth, 20, 1e-2);
}

// Monostatic sigma [m^2] of the published sets: 30-digit quadrature.
struct Published {
  const char* name;
  double sphere, plate0, plate30, plate60, cylinder, cone;
};
constexpr Published published[] = {
    {"metal-skin-5p", 3.509758352, 2.111150263, 1.131587412, 0.4282831334, 2.749972067, 2.258011689},
    {"metal-skin-9p", 3.491442528, 2.03575204, 1.266039804, 0.3582504576, 2.804345802, 1.872463526},
    {"painted-steel-5p", 3.395819309, 2.111150263, 1.244641469, 0.3541174223, 2.780478203, 1.215643369},
    {"painted-steel-9p", 3.122526695, 2.318495378, 1.302755612, 0.2107559971, 2.828173684, 0.7902136484},
};

class PublishedSet : public testing::TestWithParam<Published> {};

TEST_P(PublishedSet, PlateIsExact) {
  const Published& p = GetParam();
  FacetMesh plate;
  add_plate(plate, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto at = [&](double t) { return sigma(plate, library(p.name), from_z(t), from_z(t)); };
  EXPECT_NEAR(at(0.0), p.plate0, 1e-9 * p.plate0);
  EXPECT_NEAR(at(30.0 * degree), p.plate30, 1e-9 * p.plate30);
  EXPECT_NEAR(at(60.0 * degree), p.plate60, 1e-9 * p.plate60);
}

TEST_P(PublishedSet, SphereConvergesAtSecondOrder) {
  const Published& p = GetParam();
  const Vec3 d(0, 0, 1);
  expect_second_order([&](auto n) { return sigma(sphere(1.0, n), library(p.name), d, d); }, p.sphere, 30, 3e-3);
}

TEST_P(PublishedSet, CylinderConvergesAtSecondOrder) {
  const Published& p = GetParam();
  expect_second_order(
      [&](auto n) {
        Target target = target_of(cylinder_side(n), library(p.name));
        target.sides = Sides::front;
        const Vec3 d = Eigen::AngleAxisd(pi / n, Vec3::UnitZ()) * Vec3(1, 0, 0);
        return section_of(target, d, d).sigma.value;
      },
      p.cylinder, 48, 3e-3);
}

TEST_P(PublishedSet, ConeConvergesAtSecondOrder) {
  const Published& p = GetParam();
  const Vec3 d(0, 0, 1);
  expect_second_order([&](auto n) { return sigma(cone(n), library(p.name), d, d); }, p.cone, 24, 8e-3);
}

INSTANTIATE_TEST_SUITE_P(Materials, PublishedSet, testing::ValuesIn(published), [](const auto& set) {
  std::string name = set.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace lrcs
