#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lrcs {

// One measured value of a BRDF. Angles of the true geometry, whatever the file's convention.
struct BrdfSample {
  double theta_i = 0.0;  // [rad] from the normal to the transmitter, [0, pi/2)
  double theta_r = 0.0;  // [rad] from the normal to the receiver, [0, pi/2)
  double phi = 0.0;     // [rad] between the azimuths of the two, (-pi, pi]: 0 on the retro side, pi on the specular one
  double f_r = 0.0;     // [1/sr] >= 0
  double weight = 1.0;  // [1] >= 0
  int line = 0;         // of the file; 0: it has no lines
};

// What a goniometer measured of one surface at one wavelength.
struct BrdfMeasurement {
  std::string name;                   // the file's, without folders
  std::string format;                 // in words: "Zemax BSDF", ...
  double wavelength = 0.0;            // [m]; 0: not stated
  std::vector<BrdfSample> samples;    // in file order
  std::vector<std::string> notes;     // a sentence each: how the file's convention was read, what was left out and why
  std::vector<std::string> warnings;  // a sentence each: what a user should look at before trusting the numbers
};

// Adds a warning where all samples have the same theta_i. domain: samples not empty.
void warn_of_one_incidence(BrdfMeasurement& measurement);

// The one whose wavelength [m] is nearest to that asked for; null where none is within a thousandth of it.
[[nodiscard]] const BrdfMeasurement* measured_at(const std::vector<BrdfMeasurement>& measurements, double wavelength);

// What a file may leave unsaid. Where the file says otherwise, that is an error.
struct MeasurementOptions {
  std::optional<int> azimuth_of_specular;  // [deg] 180 or 0: the file's azimuth at which the specular direction lies
  std::optional<bool> value_has_cosine;    // the value is f_r cos(theta_r)
};

// Reads a file of measured BRDFs; which kind it is, its content tells. shape: one a wavelength, shortest first; not
// empty. error: InputError at file:line:column.
[[nodiscard]] std::vector<BrdfMeasurement> read_brdf_measurements(const std::filesystem::path& file,
                                                                  const MeasurementOptions& options = {});

}  // namespace lrcs
