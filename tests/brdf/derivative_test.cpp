#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/brdf/random_parameters.h"

namespace lrcs {
namespace {

template <class Form>
class EveryFormsDerivatives : public testing::Test {};
TYPED_TEST_SUITE(EveryFormsDerivatives, EveryForm);

template <class Form, class T>
using ValuesOf = forms::Values<T, Form::parameters.size()>;

template <class Form>
auto jets(const ValuesOf<Form, double>& values) {
  constexpr int count = static_cast<int>(Form::parameters.size());
  ValuesOf<Form, ceres::Jet<double, count>> jets;
  for (int k = 0; k < count; ++k) jets[k] = ceres::Jet<double, count>(values[k], k);
  return jets;
}

// Central difference of sixth order, in long double.
template <class Form>
double difference(const ValuesOf<Form, double>& values, std::size_t active, const Vec3& wi, const Vec3& wr,
                  const Vec3& n) {
  const long double h = 1e-3L * std::abs(static_cast<long double>(values[active]));
  const auto at = [&](int steps) {
    ValuesOf<Form, long double> v{};
    std::copy(values.begin(), values.end(), v.begin());
    v[active] += steps * h;
    return Form::make(v, 180).f_cos_cos(wi, wr, n);
  };
  return static_cast<double>((45.0L * (at(1) - at(-1)) - 9.0L * (at(2) - at(-2)) + (at(3) - at(-3))) / (60.0L * h));
}

TYPED_TEST(EveryFormsDerivatives, AreThoseOfHighOrderDifferences) {
  RandomDirections random(21);
  for (int k = 0; k < 2000; ++k) {
    auto values = random_parameters<TypeParam>(random);
    const Vec3 n = random.on_sphere();
    const Vec3 wi = random.above(n, 1.5);
    const Vec3 wr = random.above(n, 1.5);
    const auto value = TypeParam::make(jets<TypeParam>(values), 180).f_cos_cos(wi, wr, n);
    const double largest = TypeParam::make(values, 180).f_cos_cos(wi, wr, n);
    EXPECT_NEAR(value.a, largest, 1e-14 * largest);
    for (std::size_t active = 0; active < values.size(); ++active) {
      if (std::abs(values[active]) * 1.003 > std::abs(TypeParam::parameters[active].most)) continue;
      const double size = std::abs(values[active]);
      EXPECT_NEAR(size * value.v[static_cast<int>(active)], size * difference<TypeParam>(values, active, wi, wr, n),
                  1e-7 * largest)
          << TypeParam::name << ' ' << TypeParam::parameters[active].name;
    }
  }
}

TYPED_TEST(EveryFormsDerivatives, AreNumbersAtRetroReflectionAndAlongTheNormal) {
  RandomDirections random(22);
  const Vec3 n = Vec3::UnitZ();
  for (const Vec3& w : {from_angles(0.7, 0.3), n, from_angles(1e-9, 1.0), from_angles(1.57, 2.0)})
    for (int k = 0; k < 100; ++k) {
      const auto model = TypeParam::make(jets<TypeParam>(random_parameters<TypeParam>(random)), 180);
      const auto both = model.f_cos_cos(w, w, n);
      const auto retro = model.f_cos_cos_retro(w.z());
      EXPECT_TRUE(both.v.allFinite() && retro.v.allFinite());
      EXPECT_LE((both.v - retro.v).norm(), 1e-6 * retro.v.norm() + 1e-300);
    }
}

TYPED_TEST(EveryFormsDerivatives, HaveLinearParametersThatAreLinear) {
  RandomDirections random(23);
  for (int k = 0; k < 300; ++k) {
    auto values = random_parameters<TypeParam>(random);
    const Vec3 n = Vec3::UnitZ();
    const Vec3 wi = random.above(n, 1.5);
    const Vec3 wr = random.above(n, 1.5);
    const double whole = TypeParam::make(values, 180).f_cos_cos(wi, wr, n);
    double sum = 0.0;
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (!TypeParam::parameters[j].is_linear) continue;
      auto unit = values;
      for (std::size_t i = 0; i < unit.size(); ++i)
        if (TypeParam::parameters[i].is_linear) unit[i] = i == j ? 1.0 : 0.0;
      sum += values[j] * TypeParam::make(unit, 180).f_cos_cos(wi, wr, n);
    }
    EXPECT_NEAR(sum, whole, 1e-14 * whole);
  }
}

TEST(WuDerivatives, AreNumbersWithoutShadowing) {
  auto values = forms::NineParameterForm::values(std::get<Wu>(find_in_library("metal-skin-9p")->brdf));
  values[5] = 0.0;
  const Vec3 w = from_angles(0.7, 0.3);
  const auto model = forms::NineParameterForm::make(jets<forms::NineParameterForm>(values), 180);
  const Vec3 n = Vec3::UnitZ();
  EXPECT_TRUE(model.f_cos_cos(w, w, n).v.allFinite());
}

}  // namespace
}  // namespace lrcs
