#include "fit/coordinate.h"

#include <gtest/gtest.h>

#include "tests/brdf/random_parameters.h"

namespace lrcs {
namespace {

template <class Form>
class Coordinate : public testing::Test {};
TYPED_TEST_SUITE(Coordinate, EveryForm);

TYPED_TEST(Coordinate, GivesTheValueBack) {
  RandomDirections random(1);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const auto values = random_parameters<TypeParam>(random);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const FormParameter& p = TypeParam::parameters[k];
      EXPECT_NEAR(value_at(p, coordinate_of(p, values[k])), values[k], 1e-13 * (1.0 + std::abs(values[k]))) << p.name;
    }
  }
}

TYPED_TEST(Coordinate, IsZeroToOneWhereASearchBeginsAndKeepsToTheRangeBeyond) {
  for (const FormParameter& p : TypeParam::parameters) {
    if (p.scale != FormParameter::Scale::ratio) {
      EXPECT_NEAR(value_at(p, 0.0), p.from, 1e-12 * (1.0 + std::abs(p.from))) << p.name;
      EXPECT_NEAR(value_at(p, 1.0), std::min(p.to, p.most), 1e-12 * (1.0 + std::abs(p.to))) << p.name;
    }
    EXPECT_EQ(value_at(p, -1e300), p.least) << p.name;
    EXPECT_EQ(value_at(p, 1e300), p.most) << p.name;
    for (const double end : {p.least, p.most}) {
      EXPECT_TRUE(is_at_end(p, end)) << p.name;
      EXPECT_NEAR(value_at(p, coordinate_of(p, end)), end, 1e-8 * std::abs(end)) << p.name;
    }
  }
}

TYPED_TEST(Coordinate, TellsTheInsideFromTheEnds) {
  RandomDirections random(2);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const auto values = random_parameters<TypeParam>(random);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const FormParameter& p = TypeParam::parameters[k];
      if (values[k] > p.least && values[k] < p.most) {
        EXPECT_FALSE(is_at_end(p, values[k])) << p.name << values[k];
      }
    }
  }
}

TYPED_TEST(Coordinate, HasTheSlopeOfItsDifferences) {
  constexpr double h = 1e-5;
  for (const FormParameter& p : TypeParam::parameters)
    for (const double x : {0.1, 0.3, 0.5, 0.8, 0.9}) {
      const double difference = (value_at(p, x + h) - value_at(p, x - h)) / (2.0 * h);
      EXPECT_NEAR(slope_at(p, value_at(p, x)), difference, 1e-7 * std::abs(difference)) << p.name << " at " << x;
    }
}

}  // namespace
}  // namespace lrcs
