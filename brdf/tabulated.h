#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_error.h"
#include "base/vec3.h"
#include "brdf/model_pair.h"
#include "brdf/scalar.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

// What a tabulated BRDF makes of directions that were not measured.
enum class Outside {
  error,    // NotMeasured
  nearest,  // the value at the nearest place that was, by projection to the hull of the samples (brdf/pair_place.h)
  zero
};
[[nodiscard]] std::string_view word_of(Outside outside);

// A tabulated BRDF was asked for directions that were not measured. what() names file, angles, and what to add.
class NotMeasured : public InputError {
 public:
  using InputError::InputError;
};

// Where a measurement was read from, and how: enough to read it again. Empty: from no file.
struct MeasuredFile {
  std::string path;
  std::string digest;                      // SHA-256
  MeasurementOptions options;              // as the user gave them
  std::optional<double> wavelength_asked;  // [m]
};

// A BRDF straight from a measurement, for surfaces that no model fits.
// value: f_r is linear between the samples, in the tetrahedra of a Delaunay triangulation of their places
//   (brdf/pair_place.h): a lobe about the specular or the retro direction stays there between measured incidences.
//   Samples in the plane of incidence only, or at retro only, make a plane or a line; what is off it is outside.
// extension: f_r is taken to be isotropic, reciprocal and its own mirror image: a sample counts for all directions that
//   these make of its own. Samples that fall together to within 1e-6 rad count as their mean by weight; samples of
//   weight 0 do not count.
// domain: inside the convex hull of the places and of their images (brdf/pair_place.h), to within 1e-6 rad; elsewhere
// as Outside says. That includes gaps among the samples: a warning tells of doubtful values at retro.
//   Directions within 1e-12 of grazing, which rounding cannot tell from those of a facet that is not seen, take the
//   nearest value even where Outside::error holds.
// laws: reciprocal, to the last bit; between the least and the largest sample; the same value on any thread and in any
// order
//   of questions. The albedo is what it was measured to be: not promised to be below 1.
// error: second order in the distance of the samples where f_r is smooth: tests/brdf/tabulated_test.cpp.
// On scalars other than double it computes in double.
class Tabulated {
 public:
  static constexpr bool is_reciprocal = true;
  static constexpr std::size_t most_samples = 2000000;

  // error: InputError for no sample of a weight above 0, and for more than most_samples.
  explicit Tabulated(const BrdfMeasurement& measurement, Outside outside = Outside::error,
                     const MeasuredFile& file = {});

  [[nodiscard]] Outside outside() const { return outside_; }
  [[nodiscard]] double largest() const;
  [[nodiscard]] bool conserves_energy() const { return false; }
  // The same table with another rule.
  [[nodiscard]] Tabulated with(Outside outside) const;

  // What the measurement is: its name, format, notes and warnings, with those on the table added; no samples.
  [[nodiscard]] const BrdfMeasurement& measurement() const;
  [[nodiscard]] const MeasuredFile& file() const;
  // "tabulated file=retro.dat format=... samples=... places=... outside=error"
  [[nodiscard]] std::string description() const;
  [[nodiscard]] std::size_t samples() const;
  [[nodiscard]] std::size_t places() const;  // that differ
  [[nodiscard]] int dimension() const;       // of what the samples fill: 0 to 3

  template <class S>
  [[nodiscard]] S f_cos_cos(const Direction<S>& wi, const Direction<S>& wr, const Direction<S>& n) const {
    return S(value(plain(wi), plain(wr), plain(n)));
  }

  template <class S>
  [[nodiscard]] S f_cos_cos_retro(const S& cos_theta) const {
    return S(value_retro(plain_value(cos_theta)));
  }

  template <class S>
  [[nodiscard]] ModelPair<Tabulated, S> for_pair(const Direction<S>& wi, const Direction<S>& wr) const {
    return {*this, wi, wr};
  }

  [[nodiscard]] double pair_error(const Direction<double>& /*wi*/, const Direction<double>& /*wr*/) const {
    return 0.0;
  }

  // Values of neighbours may differ by powers of ten: what that makes of rounding.
  [[nodiscard]] double lobe_error(const Direction<double>& wi, const Direction<double>& wr,
                                  const Direction<double>& n) const;

 private:
  struct Table;

  template <class S>
  static Direction<double> plain(const Direction<S>& w) {
    return {plain_value(w.x()), plain_value(w.y()), plain_value(w.z())};
  }
  [[nodiscard]] double value(const Vec3& wi, const Vec3& wr, const Vec3& n) const;
  [[nodiscard]] double value_retro(double cosine) const;
  // None: not measured, and Outside::error says so.
  [[nodiscard]] std::optional<double> f_r_at(const Vec3& place, double least_cosine) const;
  [[noreturn]] void complain(const Vec3& wi, const Vec3& wr, const Vec3& n) const;

  std::shared_ptr<const Table> table_;
  Outside outside_;
};

}  // namespace lrcs
