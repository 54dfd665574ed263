#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/natural_neighbor_coordinates_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "measured_files.h"

// AnoBlack EC1 was measured once and published twice: FRED's table is the goniometer's own grid, the Zemax file was
// resampled from it around the specular ray. Both are read here, and the resampling is done again.

namespace lrcs {
namespace {

using std::numbers::pi;
constexpr double rounding = 1e-9;  // [rad], [deg] or [1]: of angles that went through vectors
constexpr double incidences_deg[] = {10, 30, 50, 70};

BrdfMeasurement zemax_file() {
  return read_brdf_measurements(LRCS_EXAMPLES "/brdf/AnoBlackEC1onAlum.bsdf").front();
}

BrdfMeasurement fred_file() {
  return read_brdf_measurements(data_file("AnoBlackEC1onAlum_fred_fullAz.txt")).front();
}

std::vector<BrdfSample> at_incidence(const BrdfMeasurement& m, double theta_i) {
  std::vector<BrdfSample> found;
  for (const BrdfSample& s : m.samples) {
    if (std::abs(s.theta_i - theta_i) < rounding) found.push_back(s);
  }
  return found;
}

double f_cos(const BrdfSample& s) {
  return s.f_r * std::cos(s.theta_r);
}

double largest_f_cos(const std::vector<BrdfSample>& samples) {
  double largest = 0.0;
  for (const BrdfSample& s : samples) largest = std::max(largest, f_cos(s));
  return largest;
}

constexpr double half_unit_of_fred = 0.5e-6;

// Of the last of the four digits in which the Zemax file states f_r.
double half_unit_of_zemax(double f_r) {
  return 0.5 * std::pow(10.0, std::floor(std::log10(f_r)) - 3.0);
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polar = Kernel::Point_2;  // (azimuth, radial) [deg] around the specular ray, azimuth 0 toward the normal

Polar around_specular(const Vec3& wr, double theta_i) {
  const double along = wr.dot(toward(pi / 2.0 - theta_i, 0.0));
  const double radial = std::atan2(std::hypot(along, wr.y()), wr.dot(toward(theta_i, pi)));
  return {std::atan2(wr.y(), along) / degree, radial / degree};
}

// Moved by 3.29 deg across the plane of incidence, then folded to azimuths of 0 to 180. The makers took the largest
// single reading of each incidence for the lobe's middle; these lie 0, 4.981, 8.186 and 0 deg beside the plane. FRED's
// table has the averages of two readings, whose largest lie in the plane.
Polar moved(const Polar& p) {
  const double along = p.y() * std::cos(p.x() * degree);
  const double across = p.y() * std::sin(p.x() * degree) + 3.291847;
  return {std::atan2(std::abs(across), along) / degree, std::hypot(along, across)};
}

// FRED's table has each value twice, mirrored in the plane of incidence; the makers moved one of the two: on the
// specular side that at y <= 0, toward the plane, on the retro side that at y >= 0, away from it.
bool is_moved(const BrdfSample& s) {
  const Vec3 w = toward(s.theta_r, s.phi);
  return w.x() * w.y() > -rounding;
}

// f_r of one incidence, f_r cos(theta_r) interpolated between the moved samples by natural neighbours (Sibson) in the
// plane of (azimuth, radial). On the specular ray stands the largest value, wherever it was measured.
class Resampled {
 public:
  Resampled(const BrdfMeasurement& fred, double theta_i) : theta_i_(theta_i) {
    const auto samples = at_incidence(fred, theta_i);
    largest_ = largest_f_cos(samples);
    for (int azimuth = -90; azimuth <= 270; azimuth += 10) values_[Polar(azimuth, 0)] = largest_;
    for (const BrdfSample& s : samples) {
      if (is_moved(s)) add_with_mirror_image(moved(around_specular(toward(s.theta_r, s.phi), theta_i)), f_cos(s));
    }
    for (const auto& [place, value] : values_) neighbours_.insert(place);
  }

  // 0 outside the hull of the samples.
  [[nodiscard]] double f_r(const Vec3& wr) const {
    const Polar place = around_specular(wr, theta_i_);
    return (place.y() < rounding ? largest_ : interpolated(place)) / wr.z();
  }

 private:
  void add_with_mirror_image(const Polar& p, double value) {
    values_[p] = value;
    values_[Polar(p.x() < 90.0 ? -p.x() : 360.0 - p.x(), p.y())] = value;
  }

  [[nodiscard]] double interpolated(const Polar& place) const {
    std::vector<std::pair<Polar, double>> shares;
    const auto found = CGAL::natural_neighbor_coordinates_2(neighbours_, place, std::back_inserter(shares));
    double sum = 0.0;
    for (const auto& [neighbour, share] : shares) sum += share * values_.at(neighbour);
    return found.third ? sum / found.second : 0.0;
  }

  double theta_i_;
  double largest_ = 0.0;
  std::map<Polar, double> values_;  // f_r cos(theta_r)
  CGAL::Delaunay_triangulation_2<Kernel> neighbours_;
};

// What FRED's six decimals leave open, in place of its values.
BrdfMeasurement half_units_of(BrdfMeasurement fred) {
  for (BrdfSample& s : fred.samples) s.f_r = half_unit_of_fred;
  return fred;
}

// Of the Zemax file's samples with FRED's, resampled.
struct Agreement {
  int samples = 0;
  int equal = 0;          // in all four printed digits
  int within_digits = 0;  // of both files
  double worst = 0.0;     // relative difference
};

// `read_as` turns a sample's direction into the one that another reading of the Zemax file would give.
template <class ReadAs>
Agreement agreement(const ReadAs& read_as) {
  const auto zemax = zemax_file();
  const auto fred = fred_file();
  Agreement found;
  for (const double theta_i_deg : incidences_deg) {
    const double theta_i = theta_i_deg * degree;
    const Resampled resampled(fred, theta_i), left_open(half_units_of(fred), theta_i);
    for (const BrdfSample& z : at_incidence(zemax, theta_i)) {
      const Vec3 wr = read_as(toward(z.theta_r, z.phi), theta_i);
      const double difference = std::abs(z.f_r - resampled.f_r(wr));
      ++found.samples;
      found.equal += difference <= half_unit_of_zemax(z.f_r);
      found.within_digits += difference <= half_unit_of_zemax(z.f_r) + left_open.f_r(wr);
      found.worst = std::max(found.worst, difference / z.f_r);
    }
  }
  return found;
}

TEST(ZemaxAndFred, HaveTheSameLargestValueToTheirDigits) {
  const auto zemax = zemax_file();
  const auto fred = fred_file();
  for (const double theta_i_deg : incidences_deg) {
    const double theta_i = theta_i_deg * degree;
    const BrdfSample specular = at_incidence(zemax, theta_i).front();
    ASSERT_LT((toward(specular.theta_r, specular.phi) - toward(theta_i, pi)).norm(), rounding);
    EXPECT_NEAR(f_cos(specular), largest_f_cos(at_incidence(fred, theta_i)),
                half_unit_of_zemax(specular.f_r) * std::cos(theta_i) + half_unit_of_fred);
  }
}

// The six beyond the digits lie about the normal, where FRED's table has one value, an average over the goniometer's
// turns.
TEST(ZemaxAndFred, AgreeToTheirDigitsOnceResampled) {
  const Agreement as_read = agreement([](const Vec3& w, double) { return w; });
  EXPECT_EQ(as_read.samples, 647);
  EXPECT_GE(as_read.equal, 617);
  EXPECT_GE(as_read.within_digits, 641);
  EXPECT_LT(as_read.worst, 0.001);
}

// Counted from the far side of the specular ray, azimuths mean the same for the 38 samples on that ray or at
// azimuth 90.
TEST(ZemaxAndFred, DisagreeUnderAnyOtherReading) {
  const Agreement on_retro_side = agreement([](const Vec3& w, double) { return Vec3(-w.x(), w.y(), w.z()); });
  const Agreement azimuth_from_far_side = agreement([](const Vec3& w, double theta_i) {
    const Vec3 toward_normal = toward(pi / 2.0 - theta_i, 0.0);
    return Vec3(w - 2.0 * w.dot(toward_normal) * toward_normal);
  });
  EXPECT_LT(on_retro_side.within_digits, 10);
  EXPECT_LT(azimuth_from_far_side.within_digits, 38 + 10);
}

// What the resampling changed, where both files state the same direction: relative differences, ascending. All are in
// the plane of incidence.
TEST(ZemaxAndFred, DifferByTheResampling) {
  const auto fred = fred_file();
  std::vector<double> found;
  for (const BrdfSample& z : zemax_file().samples) {
    for (const BrdfSample& f : at_incidence(fred, z.theta_i)) {
      const bool is_same = (toward(f.theta_r, f.phi) - toward(z.theta_r, z.phi)).norm() < rounding;
      if (is_same) found.push_back(std::abs(z.f_r / f.f_r - 1.0));
    }
  }
  std::sort(found.begin(), found.end());
  ASSERT_EQ(found.size(), 64U);
  EXPECT_NEAR(found[32], 0.016, 0.0005);
  EXPECT_NEAR(found.back(), 0.234, 0.0005);
}

}  // namespace
}  // namespace lrcs
