#include "brdf/brdf.h"

#include <gtest/gtest.h>

#include <set>

#include "brdf/albedo.h"
#include "brdf/brdf_table.h"
#include "tests/brdf/sample_brdfs.h"

namespace lrcs {
namespace {

constexpr double right_angle = std::numbers::pi / 2.0;

TEST(EveryBrdf, HasASampleForTheLawTests) {
  std::set<std::size_t> models;
  for (const Brdf& brdf : sample_brdfs()) models.insert(brdf.index());
  EXPECT_EQ(models.size(), std::variant_size_v<Brdf>);
}

TEST(EveryBrdf, LiesBetweenZeroAndItsBound) {
  RandomDirections random(1);
  for (const Brdf& brdf : sample_brdfs()) {
    const double largest = std::visit([](const auto& model) { return model.largest(); }, brdf);
    for (int k = 0; k < 20000; ++k) {
      const Vec3 n = random.on_sphere();
      const double value = f_cos_cos(brdf, random.above(n, right_angle), random.above(n, right_angle), n);
      ASSERT_GE(value, 0.0);
      ASSERT_LE(value, largest * (1.0 + 1e-12));
    }
  }
}

TEST(EveryBrdf, VanishesBelowTheSurface) {
  RandomDirections random(2);
  for (const Brdf& brdf : sample_brdfs())
    for (int k = 0; k < 1000; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 above = random.above(n, 1.5);
      const Vec3 below = -random.above(n, 1.5);
      EXPECT_EQ(f_cos_cos(brdf, above, below, n), 0.0);
      EXPECT_EQ(f_cos_cos(brdf, below, above, n), 0.0);
      EXPECT_EQ(f_cos_cos(brdf, below, below, n), 0.0);
      EXPECT_EQ(f_r(brdf, above, below, n), 0.0);
    }
}

TEST(EveryBrdf, IsZeroForOppositeDirections) {
  RandomDirections random(3);
  for (const Brdf& brdf : sample_brdfs())
    for (int k = 0; k < 1000; ++k) {
      const Vec3 wi = random.on_sphere();
      const Vec3 opposite = -wi;
      const Vec3 across = wi.cross(random.on_sphere()).normalized();
      EXPECT_EQ(f_cos_cos(brdf, wi, opposite, random.on_sphere()), 0.0);
      const double largest = std::visit([](const auto& model) { return model.largest(); }, brdf);
      EXPECT_LE(f_cos_cos(brdf, wi, opposite, across), 1e-15 * std::max(largest, 1.0));
    }
}

TEST(EveryBrdf, StaysAValueInTheMostAwkwardDirections) {
  std::vector<Vec3> awkward;
  for (const double x : {0.0, 1.0, -1.0, 1e-16, 1e-170, 1e-308, 5e-324})
    for (const double y : {0.0, 1.0, -1e-16, 1e-200})
      for (const double z : {0.0, 1.0, 1e-9, 1e-160, 2.3e-308, 5e-324}) {
        const double length = std::sqrt(x * x + y * y + z * z);
        if (length > 0.9) awkward.emplace_back(x / length, y / length, z / length);
      }
  for (const Brdf& brdf : sample_brdfs()) {
    const double largest = std::visit([](const auto& model) { return model.largest(); }, brdf);
    for (const Vec3& wi : awkward)
      for (const Vec3& wr : awkward) {
        const double value = f_cos_cos(brdf, wi, wr, Vec3(0.0, 0.0, 1.0));
        ASSERT_TRUE(value >= 0.0 && value <= largest * (1.0 + 1e-12)) << wi.transpose() << " | " << wr.transpose();
      }
  }
}

TEST(EveryBrdf, DoesNotChangeWhenAllIsTurned) {
  RandomDirections random(4);
  for (const Brdf& brdf : sample_brdfs())
    for (int k = 0; k < 3000; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 wi = random.above(n, 1.5);
      const Vec3 wr = random.above(n, 1.5);
      const Eigen::AngleAxisd turn(random.uniform(0.0, 6.0), random.on_sphere());
      const double value = f_cos_cos(brdf, wi, wr, n);
      EXPECT_NEAR(f_cos_cos(brdf, Vec3(turn * wi), Vec3(turn * wr), Vec3(turn * n)), value, 1e-11 * value + 1e-16);
    }
}

TEST(EveryBrdf, IsTheSameInAMirror) {
  RandomDirections random(5);
  const auto mirrored = [](const Vec3& w) { return Vec3(-w.x(), w.y(), w.z()); };
  for (const Brdf& brdf : sample_brdfs())
    for (int k = 0; k < 1000; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 wi = random.above(n, 1.5);
      const Vec3 wr = random.above(n, 1.5);
      EXPECT_DOUBLE_EQ(f_cos_cos(brdf, mirrored(wi), mirrored(wr), mirrored(n)), f_cos_cos(brdf, wi, wr, n));
    }
}

TEST(EveryBrdf, IsReciprocalWhereItSaysSo) {
  RandomDirections random(6);
  for (const Brdf& brdf : sample_brdfs()) {
    const bool promised = std::visit([](const auto& model) { return model.is_reciprocal; }, brdf);
    for (int k = 0; promised && k < 1000; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 wi = random.above(n, 1.5);
      const Vec3 wr = random.above(n, 1.5);
      EXPECT_DOUBLE_EQ(f_r(brdf, wi, wr, n), f_r(brdf, wr, wi, n));
    }
  }
}

TEST(EveryBrdf, ReturnsNoMoreThanItGetsWhereItSaysSo) {
  int promised = 0;
  for (const Brdf& brdf : sample_brdfs()) {
    if (!std::visit([](const auto& model) { return model.conserves_energy(); }, brdf)) continue;
    ++promised;
    for (const double theta : {0.0, 0.4, 0.8, 1.1, 1.3, 1.45, 1.55, 1.57}) {
      const Estimate a = albedo(brdf, theta, 1e-4);
      EXPECT_LE(a.value - a.bound, 1.0) << description_of(brdf) << " at " << theta;
    }
  }
  EXPECT_GE(promised, 8);
}

TEST(EveryBrdf, HasTheMonostaticFormAsItsValueAtEqualDirections) {
  RandomDirections random(7);
  for (const Brdf& brdf : sample_brdfs())
    for (int k = 0; k < 3000; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 w = random.above(n, 1.55);
      const double both = f_cos_cos(brdf, w, w, n);
      const double retro = std::visit([&](const auto& model) { return model.f_cos_cos_retro(w.dot(n)); }, brdf);
      // A rounding of the cosine is one of theta by 1e-16/sin theta, which a narrow lobe follows by as much over theta.
      const double narrow = lobe_error(brdf, w, w, n);
      EXPECT_NEAR(retro, both, both * (1e-12 + 1e-15 / w.cross(n).squaredNorm()) + narrow) << w.dot(n);
    }
}

TEST(EveryBrdf, GivesTheSameThroughThePairForm) {
  RandomDirections random(8);
  for (const Brdf& brdf : sample_brdfs())
    for (int k = 0; k < 1000; ++k) {
      const Vec3 wi = random.on_sphere();
      const Vec3 wr = random.on_sphere();
      const Vec3 n = random.on_sphere();
      const double pair = std::visit([&](const auto& model) { return model.for_pair(wi, wr)(n); }, brdf);
      EXPECT_EQ(pair, f_cos_cos(brdf, wi, wr, n));
    }
}

TEST(EveryBrdf, AcceptsACosineThatRoundingPutAboveOne) {
  for (const Brdf& brdf : sample_brdfs()) {
    const auto retro = [&](double c) {
      return std::visit([&](const auto& model) { return model.f_cos_cos_retro(c); }, brdf);
    };
    EXPECT_NEAR(retro(1.0 + 4e-16), retro(1.0), 1e-15);
    EXPECT_EQ(retro(0.0), 0.0);
    EXPECT_EQ(retro(-0.5), 0.0);
  }
}

TEST(EveryBrdf, ComesToTheSameOnLongDouble) {
  RandomDirections random(9);
  for (const Brdf& brdf : sample_brdfs())
    for (int k = 0; k < 1000; ++k) {
      const Vec3 n = random.on_sphere();
      const Vec3 wi = random.above(n, 1.5);
      const Vec3 wr = random.above(n, 1.5);
      using Long = Direction<long double>;
      const auto longer = f_cos_cos(brdf, wi, wr, n);
      const long double value = std::visit(
          [&](const auto& model) {
            return model.f_cos_cos(Long(wi.cast<long double>()), Long(wr.cast<long double>()),
                                   Long(n.cast<long double>()));
          },
          brdf);
      EXPECT_NEAR(static_cast<double>(value), longer, 1e-11 * longer + 1e-16);
    }
}

TEST(Lambert, IsTheReflectanceOverPiEverywhere) {
  EXPECT_DOUBLE_EQ(f_r_angles(Lambert(0.8), 0.3, 1.2, 2.0), 0.8 / std::numbers::pi);
  EXPECT_DOUBLE_EQ(Lambert(0.8).f_cos_cos_retro(0.5), 0.2 / std::numbers::pi);
  EXPECT_EQ(f_r_angles(Lambert(), 0.3, 1.2, 2.0), 0.0);
}

TEST(Lambert, RefusesAReflectanceOutsideZeroToOne) {
  for (const double wrong : {-0.1, 1.0000001, std::nan(""), HUGE_VAL}) EXPECT_THROW(Lambert{wrong}, ParameterError);
}

}  // namespace
}  // namespace lrcs
