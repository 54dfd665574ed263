#include "lrcs/aspect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lrcs {
namespace {

Receiver bistatic(double angle_deg, Receiver::Plane plane) {
  Receiver receiver;
  receiver.kind = Receiver::Kind::bistatic;
  receiver.bistatic_angle_deg = angle_deg;
  receiver.plane = plane;
  return receiver;
}

constexpr auto planes = {Receiver::Plane::azimuth, Receiver::Plane::elevation};

double angle_between_deg(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) / degree;
}

TEST(Aspect, OfABistaticReceiverHasTheTrueAngleBetweenTheDirections) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> azimuth(-360.0, 360.0), elevation(-90.0, 90.0), angle(-180.0, 180.0);
  for (int k = 0; k < 2000; ++k)
    for (const auto plane : planes) {
      const AspectAngles transmitter{azimuth(random), elevation(random)};
      const double b = angle(random);
      const Aspect aspect = aspect_of(transmitter, bistatic(b, plane));
      EXPECT_NEAR(angle_between_deg(aspect.to_transmitter, aspect.to_receiver), std::abs(b), 1e-12);
      EXPECT_NEAR(aspect.to_receiver.norm(), 1.0, 4e-16);
      EXPECT_LT((direction_of(aspect.receiver) - aspect.to_receiver).norm(), 1e-14);
      EXPECT_EQ(aspect.transmitter, transmitter);
    }
}

TEST(Aspect, OfABistaticReceiverLiesInItsPlane) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> azimuth(0.0, 360.0), elevation(-90.0, 90.0), angle(-180.0, 180.0);
  for (int k = 0; k < 2000; ++k) {
    const AspectAngles transmitter{azimuth(random), elevation(random)};
    const double b = angle(random);
    const Vec3 toward_azimuth = along_azimuth(transmitter), toward_elevation = along_elevation(transmitter);
    const Vec3 in_azimuth = aspect_of(transmitter, bistatic(b, Receiver::Plane::azimuth)).to_receiver;
    EXPECT_NEAR(in_azimuth.dot(toward_elevation), 0.0, 1e-15);
    EXPECT_NEAR(in_azimuth.dot(toward_azimuth), std::sin(b * degree), 1e-15);
    const Vec3 in_elevation = aspect_of(transmitter, bistatic(b, Receiver::Plane::elevation)).to_receiver;
    EXPECT_NEAR(in_elevation.dot(toward_azimuth), 0.0, 1e-15);
    EXPECT_NEAR(in_elevation.dot(toward_elevation), std::sin(b * degree), 1e-15);
  }
}

TEST(Aspect, OnTheEquatorAndOnAMeridianIsASumOfAngles) {
  const AspectAngles level = aspect_of({40.0, 0.0}, bistatic(30.0, Receiver::Plane::azimuth)).receiver;
  EXPECT_NEAR(level.azimuth_deg, 70.0, 1e-13);
  EXPECT_NEAR(level.elevation_deg, 0.0, 1e-13);
  const AspectAngles above = aspect_of({40.0, 20.0}, bistatic(-30.0, Receiver::Plane::elevation)).receiver;
  EXPECT_NEAR(above.azimuth_deg, 40.0, 1e-13);
  EXPECT_NEAR(above.elevation_deg, -10.0, 1e-13);
  const AspectAngles over_the_pole = aspect_of({40.0, 80.0}, bistatic(30.0, Receiver::Plane::elevation)).receiver;
  EXPECT_NEAR(over_the_pole.azimuth_deg, 220.0, 1e-12);
  EXPECT_NEAR(over_the_pole.elevation_deg, 70.0, 1e-12);
}

TEST(Aspect, OfBistaticAngleZeroIsMonostaticToTheLastBit) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> azimuth(-360.0, 360.0), elevation(-90.0, 90.0);
  for (int k = 0; k < 1000; ++k) {
    const AspectAngles transmitter{azimuth(random), elevation(random)};
    const Aspect mono = aspect_of(transmitter, {});
    EXPECT_EQ(mono.to_receiver, mono.to_transmitter);
    EXPECT_EQ(mono.receiver, transmitter);
    for (const auto plane : planes)
      for (const double zero : {0.0, -0.0}) {
        const Aspect aspect = aspect_of(transmitter, bistatic(zero, plane));
        EXPECT_EQ(aspect.to_transmitter, mono.to_transmitter);
        EXPECT_EQ(aspect.to_receiver, mono.to_transmitter);
        EXPECT_EQ(aspect.receiver, transmitter);
      }
  }
}

TEST(Aspect, OfBistaticAngle180LooksFromTheOtherSide) {
  for (const auto plane : planes)
    for (const AspectAngles transmitter : {AspectAngles{0.0, 0.0}, {33.0, 21.0}, {90.0, -90.0}}) {
      const Aspect aspect = aspect_of(transmitter, bistatic(180.0, plane));
      EXPECT_LT((aspect.to_receiver + aspect.to_transmitter).norm(), 1e-15);
    }
}

TEST(Aspect, AtThePolesGoesByTheAzimuthThatWasSaid) {
  for (const double pole : {90.0, -90.0})
    for (const double azimuth : {0.0, 30.0, 200.0}) {
      const AspectAngles transmitter{azimuth, pole};
      const Aspect across = aspect_of(transmitter, bistatic(50.0, Receiver::Plane::azimuth));
      EXPECT_EQ(across.to_transmitter, Vec3(0.0, 0.0, pole / 90.0));
      EXPECT_NEAR(across.receiver.azimuth_deg, std::fmod(azimuth + 90.0, 360.0), 1e-12);
      EXPECT_NEAR(std::abs(across.receiver.elevation_deg), 40.0, 1e-12);
      const Aspect over = aspect_of(transmitter, bistatic(50.0, Receiver::Plane::elevation));
      // Past the upper pole growing elevation leads to the far side; from the lower one to the near side.
      EXPECT_NEAR(over.receiver.azimuth_deg, std::fmod(azimuth + (pole > 0.0 ? 180.0 : 0.0), 360.0), 1e-12);
      EXPECT_NEAR(over.receiver.elevation_deg, pole > 0.0 ? 40.0 : -40.0, 1e-12);
    }
}

TEST(Aspect, OfAFixedReceiverDoesNotFollowTheTransmitter) {
  Receiver receiver;
  receiver.kind = Receiver::Kind::fixed;
  receiver.fixed = {40.0, 20.0};
  for (const double azimuth : {0.0, 100.0, 359.0}) {
    const Aspect aspect = aspect_of({azimuth, 5.0}, receiver);
    EXPECT_EQ(aspect.to_receiver, direction_of({40.0, 20.0}));
    EXPECT_EQ(aspect.receiver, receiver.fixed);
    EXPECT_EQ(aspect.to_transmitter, direction_of({azimuth, 5.0}));
  }
}

}  // namespace
}  // namespace lrcs
