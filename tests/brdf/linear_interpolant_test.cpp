#include "brdf/linear_interpolant.h"

#include <gtest/gtest.h>

#include <random>

#include "brdf/merged_places.h"

namespace lrcs {
namespace {

constexpr double tolerance = 1e-6;

class RandomPlaces {
 public:
  explicit RandomPlaces(unsigned seed) : engine_(seed) {}
  // In the unit cube; the first `dimension` coordinates only.
  Vec3 next(int dimension) {
    Vec3 place = Vec3::Zero();
    for (int k = 0; k < dimension; ++k) place[k] = uniform_(engine_);
    return place;
  }
  std::vector<Vec3> many(std::size_t count, int dimension) {
    std::vector<Vec3> places;
    while (places.size() < count) places.push_back(next(dimension));
    return places;
  }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

double linear(const Vec3& p) {
  return 3.0 + p.dot(Vec3(1.0, -0.5, 0.25));
}

std::vector<double> values_of(const std::vector<Vec3>& places, double (*f)(const Vec3&)) {
  std::vector<double> values;
  for (const Vec3& p : places) values.push_back(f(p));
  return values;
}

TEST(LinearInterpolant, IsExactForLinearFunctionsInEveryDimension) {
  RandomPlaces random(1);
  for (const int dimension : {0, 1, 2, 3}) {
    const auto places = random.many(500, dimension);
    const auto distinct = dimension == 0 ? std::vector<Vec3>{places.front()} : places;
    const LinearInterpolant f(distinct, values_of(distinct, linear), tolerance);
    EXPECT_EQ(f.dimension(), dimension);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
      const Vec3 place = random.next(dimension);
      const auto value = f.at(place);
      if (!value) continue;
      ++inside;
      EXPECT_NEAR(*value, linear(place), 1e-11);
    }
    EXPECT_GT(inside, 1500);
  }
}

TEST(LinearInterpolant, FindsAPlaneAndALineThatLieAskew) {
  RandomPlaces random(2);
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()));
  for (const int dimension : {1, 2}) {
    auto places = random.many(300, dimension);
    for (Vec3& p : places) p = turn * p + Vec3(0.3, 0.1, 0.2);
    const LinearInterpolant f(places, values_of(places, linear), tolerance);
    EXPECT_EQ(f.dimension(), dimension);
    const Vec3 inside = 0.5 * (places[0] + places[1]);
    EXPECT_NEAR(f.at(inside).value(), linear(inside), 1e-12);
    EXPECT_FALSE(f.at(inside + 1e-3 * turn.col(2)).has_value());
    EXPECT_NEAR(f.nearest(inside + 1e-3 * turn.col(2)), linear(inside), 1e-12);
  }
}

// Cospherical points by the dozen: what a regular grid is made of.
TEST(LinearInterpolant, GivesTheSamplesBackOnARegularGrid) {
  std::vector<Vec3> places;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      for (int k = 0; k < 12; ++k) places.emplace_back(0.1 * i, 0.1 * j, 0.1 * k);
  const auto values = values_of(places, [](const Vec3& p) { return std::sin(1000.0 * p.sum()) + 1.0; });
  const LinearInterpolant f(places, values, tolerance);
  for (std::size_t k = 0; k < places.size(); ++k) EXPECT_NEAR(f.at(places[k]).value(), values[k], 1e-12);
}

TEST(LinearInterpolant, IsTheValueAtTheNearestPlaceOfTheHullOutside) {
  std::vector<Vec3> cube;
  for (int k = 0; k < 8; ++k) cube.emplace_back(k & 1, k >> 1 & 1, k >> 2 & 1);
  const LinearInterpolant f(cube, values_of(cube, linear), tolerance);
  RandomPlaces random(3);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 place = 6.0 * random.next(3) - Vec3(2.5, 2.5, 2.5);
    const Vec3 nearest = place.cwiseMax(0.0).cwiseMin(1.0);
    EXPECT_NEAR(f.nearest(place), linear(nearest), 1e-12);
    EXPECT_EQ(f.at(place).has_value(), (place - nearest).norm() <= tolerance);
  }
  EXPECT_TRUE(f.at(Vec3(0.5, 0.5, 1.0 + 1e-7)).has_value());
}

TEST(LinearInterpolant, IsConstantToTheLastBitWhereTheValuesAre) {
  RandomPlaces random(4);
  const auto places = random.many(400, 3);
  const LinearInterpolant f(places, std::vector<double>(places.size(), 0.1), tolerance);
  for (int k = 0; k < 5000; ++k) EXPECT_EQ(f.nearest(2.0 * random.next(3)), 0.1);
}

TEST(LinearInterpolant, DoesNotDependOnTheOrderOfQuestions) {
  RandomPlaces random(5);
  const auto places = random.many(2000, 3);
  const auto f_of = [](const Vec3& p) { return p.squaredNorm(); };
  const LinearInterpolant f(places, values_of(places, f_of), tolerance);
  const LinearInterpolant again(places, values_of(places, f_of), tolerance);
  const auto asked = random.many(3000, 3);
  std::vector<double> forward, backward;
  for (const Vec3& p : asked) forward.push_back(f.nearest(p));
  for (auto p = asked.rbegin(); p != asked.rend(); ++p) backward.push_back(again.nearest(*p));
  EXPECT_TRUE(std::equal(forward.begin(), forward.end(), backward.rbegin()));
}

TEST(LinearInterpolant, IsNowhereSteeperThanItSays) {
  RandomPlaces random(6);
  const auto places = random.many(300, 3);
  const LinearInterpolant f(places, values_of(places, [](const Vec3& p) { return 50.0 * p.x() * p.y(); }), tolerance);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = 0.1 * Vec3::Ones() + 0.8 * random.next(3), q = p + 1e-8 * random.next(3);
    const double slope = std::abs(f.nearest(q) - f.nearest(p)) / (q - p).norm();
    EXPECT_LE(slope, std::max(f.steepness(p), f.steepness(q)) + 1e-5);
  }
}

TEST(LinearInterpolant, IsDrawnBetweenTheValuesOfTheCornersThatHaveASay) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const LinearInterpolant f(corners, {1.0, 2.0, 3.0, 4.0}, tolerance);
  const auto span_at = [&](double x, double y, double z) {
    const auto span = f.span({x, y, z}).value();
    return std::pair(span.least, span.largest);
  };
  EXPECT_EQ(span_at(0.2, 0.2, 0.2), std::pair(1.0, 4.0));
  EXPECT_EQ(span_at(0.4, 0.6, 0.0), std::pair(2.0, 3.0));  // on an edge
  EXPECT_EQ(span_at(0.0, 0.0, 1.0), std::pair(4.0, 4.0));
  EXPECT_FALSE(f.span({1.0, 1.0, 1.0}).has_value());
}

TEST(MergedPlaces, AreTheMeanByWeightOfWhatFallsTogether) {
  const Vec3 a(0.1, 0.2, 0.3), b(0.1 + 5e-7, 0.2, 0.3), c(0.1 + 5e-6, 0.2, 0.3);
  const auto [merged, repeated, spread] = merge_places({{a, c, b}, {1.0, 7.0, 4.0}, {1.0, 1.0, 2.0}}, tolerance);
  ASSERT_EQ(merged.places.size(), 2U);
  EXPECT_EQ(merged.places[0], a);
  EXPECT_NEAR(merged.values[0], 3.0, 1e-15);
  EXPECT_EQ(merged.weights[0], 3.0);
  EXPECT_EQ(merged.values[1], 7.0);
  EXPECT_EQ(repeated, 1U);
  EXPECT_NEAR(spread, std::sqrt(5.0 / 18.0), 1e-15);
}

TEST(MergedPlaces, AreFoundAcrossTheCellsOfTheSearch) {
  RandomPlaces random(7);
  PlacedValues given;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = random.next(3);
    for (const Vec3& q : {p, Vec3(p + 0.5 * tolerance * random.next(3))}) {
      given.places.push_back(q);
      given.values.push_back(1.0);
      given.weights.push_back(1.0);
    }
  }
  EXPECT_EQ(merge_places(given, tolerance).merged.places.size(), 2000U);
}

}  // namespace
}  // namespace lrcs
