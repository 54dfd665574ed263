#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "../scratch_folder.h"
#include "base/input_error.h"
#include "base/vec3.h"
#include "measurement/brdf_measurement.h"

namespace lrcs {

inline constexpr const char* csv_header = "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr\n";

// All measurements of a file of this content.
inline std::vector<BrdfMeasurement> all_of(const std::string& content, const MeasurementOptions& options = {}) {
  const ScratchFolder folder;
  folder.write("a.txt", content);
  return read_brdf_measurements(folder.path() / "a.txt", options);
}

// The first.
inline BrdfMeasurement measurement_of(const std::string& content, const MeasurementOptions& options = {}) {
  return all_of(content, options).front();
}

// The message about a file of this content, without its folder; "" where it is read.
inline std::string complaint_about(const std::string& content, const MeasurementOptions& options = {}) {
  const ScratchFolder folder;
  folder.write("a.txt", content);
  try {
    static_cast<void>(read_brdf_measurements(folder.path() / "a.txt", options));
    return "";
  } catch (const InputError& error) {
    return std::string(error.what()).substr(folder.path().string().size() + 1);
  }
}

inline std::string data_file(const std::string& name) {
  return std::string(LRCS_TEST_DATA) + "/brdf/" + name;
}

// Toward (theta, phi), n = +z.
inline Vec3 toward(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace lrcs
