#include <gmock/gmock.h>

#include <cstring>

#include "measured_files.h"

namespace lrcs {
namespace {

using testing::Contains;

constexpr std::size_t halves = 90, differences = 90, azimuths = 180;

// A reciprocal, isotropic function that knows retro from specular.
double known_f_r(const Vec3& wi, const Vec3& wr) {
  const Vec3 half = (wi + wr).normalized();
  return 0.1 + half.z() * half.z() + 0.5 * wi.dot(wr) + 0.3 * wi.z() * wr.z();
}

// The two directions of half and difference angles, built without rotations: the difference is laid off in the frame of
// the half vector.
std::pair<Vec3, Vec3> directions(double theta_h, double theta_d, double phi_d) {
  const Vec3 half = toward(theta_h, 0.0);
  const Vec3 across = toward(theta_h + 90 * degree, 0.0);
  const Vec3 aside = half.cross(across);
  const Vec3 offset = std::sin(theta_d) * (std::cos(phi_d) * across + std::sin(phi_d) * aside);
  return {std::cos(theta_d) * half + offset, std::cos(theta_d) * half - offset};
}

std::string made_merl() {
  const std::size_t count = halves * differences * azimuths;
  std::vector<double> values(3 * count, 7.0);
  for (std::size_t i = 0; i < halves; ++i)
    for (std::size_t j = 0; j < differences; ++j)
      for (std::size_t k = 0; k < azimuths; ++k) {
        const double root = (static_cast<double>(i) + 0.5) / 90.0;
        const auto [wi, wr] = directions(90 * degree * root * root, (static_cast<double>(j) + 0.5) * degree,
                                         (static_cast<double>(k) + 0.5) * degree);
        const bool below = wi.z() <= 0.0 || wr.z() <= 0.0;
        values[(i * differences + j) * azimuths + k] = below ? -1.0 : 1500.0 * known_f_r(wi, wr);
      }
  const std::int32_t dimensions[3] = {halves, differences, azimuths};
  std::string bytes(sizeof(dimensions) + values.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), dimensions, sizeof(dimensions));
  std::memcpy(bytes.data() + sizeof(dimensions), values.data(), values.size() * sizeof(double));
  return bytes;
}

TEST(MerlReader, GivesBackAKnownFunctionOfTheDirections) {
  const auto m = measurement_of(made_merl());
  EXPECT_GT(m.samples.size(), 600000U);
  double worst = 0.0;
  for (const BrdfSample& s : m.samples)
    worst = std::max(worst, std::abs(s.f_r - known_f_r(toward(s.theta_i, 0.0), toward(s.theta_r, s.phi))));
  EXPECT_LT(worst, 1e-13);
  EXPECT_THAT(m.notes, Contains(testing::HasSubstr("the red channel was read")));
  EXPECT_THAT(m.notes, Contains(testing::HasSubstr("below 0, not measured in this format, left out")));
}

TEST(BadMerl, HasAnotherSizeOrValue) {
  std::string bytes = made_merl();
  EXPECT_EQ(complaint_about(bytes.substr(0, 1000)),
            "a.txt: has 1000 bytes, expected the 34992012 of a MERL file of 90 x 90 x 180 values");
  const double infinite = HUGE_VAL;
  std::memcpy(bytes.data() + 12 + 8, &infinite, 8);
  EXPECT_EQ(complaint_about(bytes),
            "a.txt: value 2 of the red channel is inf, expected a finite number of at most 1e100");
}

}  // namespace
}  // namespace lrcs
