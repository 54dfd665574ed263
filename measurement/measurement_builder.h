#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/vec3.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

// Puts a BrdfMeasurement together from the values of a file, in file order, and judges the whole.
class MeasurementBuilder {
 public:
  // `file`: as messages name it.
  MeasurementBuilder(std::string file, std::string format);

  void set_wavelength(double metres) { measurement_.wavelength = metres; }
  void set_value_has_cosine(bool has) { value_has_cosine_ = has; }
  // The file says degrees, or means them: angles that look like radians are warned of.
  void set_angles_in_degrees() { angles_in_degrees_ = true; }
  void note(std::string sentence) { measurement_.notes.push_back(std::move(sentence)); }

  // Adds a value at angles of any sign: a negative theta_i or theta_r lies on the other side of the normal. Directions
  // at 90 deg are left out. domain: finite; zeniths at most 90 deg in size; f_r and weight not negative.
  void add(BrdfSample sample);
  // The same for directions: from the surface to the transmitter and to the receiver, n = +z. Those below the surface
  // are left out. domain: unit vectors.
  void add(const Vec3& wi, const Vec3& wr, double f_r, int line);
  // Counts a value that is left out, by why.
  void leave_out(std::string_view why);

  // The measurement with its warnings. error: InputError where nothing is left to fit.
  [[nodiscard]] BrdfMeasurement finish();

 private:
  // Angles of one kind, as the file has them [deg], without their signs.
  struct Sizes {
    double least = 0.0, most = 0.0;  // of those that are not 0; 0: there are none
    bool all_whole = true;

    void see(double angle);
  };

  void put(BrdfSample sample);
  void require_something_to_fit() const;
  void note_what_is_left_out();
  void warn_of_radians();
  void warn_of_bright_surface();

  std::string file_;
  BrdfMeasurement measurement_;
  bool value_has_cosine_ = false;
  bool angles_in_degrees_ = false;
  Sizes theta_i_, theta_r_, phi_;
  std::vector<std::pair<std::string, std::size_t>> left_out_;
};

}  // namespace lrcs
