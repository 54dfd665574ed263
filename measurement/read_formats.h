#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "measurement/brdf_measurement.h"

namespace lrcs {

// The readers of each format, for read_brdf_measurements(). `content`: the file's, without a byte order mark; `file`:
// its name in messages.
// error: InputError at file:line:column.

using Measurements = std::vector<BrdfMeasurement>;

// Columns theta_i_deg, theta_r_deg, phi_deg, f_r_per_sr and weight, which may be left out, in any order; others are
// ignored. Comments "# wavelength: 1.06 um", "# azimuth_of_specular: 180 | 0", "# value: brdf | brdf_cosine".
[[nodiscard]] Measurements read_csv(std::string_view content, const std::string& file,
                                    const MeasurementOptions& options);

// ALTA's text format: [rad], PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI, ISOTROPIC_TV_TL_DPHI or
// RUSIN_TH_TD_PD; PARAM_OUT INV_STERADIAN or INV_STERADIAN_COSINE_FACTOR (of the view direction); one channel.
// source: ALTA, sources/core/params.{h,cpp} and data_storage.cpp.
[[nodiscard]] Measurements read_alta(std::string_view content, const std::string& file,
                                     const MeasurementOptions& options);

// Zemax OpticStudio's tabular BSDF. frame: ScatterRadial is the angle from the specular ray, ScatterAzimuth turns
// around it and is 0 toward the normal. A value of 0 is one not measured.
[[nodiscard]] Measurements read_zemax(std::string_view content, const std::string& file,
                                      const MeasurementOptions& options);

// FRED's "type bsdf_data". frame: theta from the normal, phi 0 on the specular side.
[[nodiscard]] Measurements read_fred(std::string_view content, const std::string& file,
                                     const MeasurementOptions& options);

// MERL's binary. Values stand at the middle of their bins: theta_half = 90 deg ((i + 1/2)/90)^2, theta_diff and
// phi_diff (j + 1/2) deg. A negative value is one not measured. Of three channels the red one is read. source: W.
// Matusik et al., A data-driven reflectance model, 2003; BRDFRead.cpp that comes with the data.
[[nodiscard]] Measurements read_merl(std::string_view content, const std::string& file,
                                     const MeasurementOptions& options);

// A table named in a comment "# phi_i theta_i phi_o theta_o brdf": phi is the zenith, theta the azimuth [deg].
[[nodiscard]] Measurements read_lumos(std::string_view content, const std::string& file,
                                      const MeasurementOptions& options);

// "lambda,thetai,phi,thetar,phir,f_r11,...": one measurement a lambda [um].
// source: T. Germer, Full four-dimensional and reciprocal Mueller matrix BRDF of sintered PTFE, 2017.
[[nodiscard]] Measurements read_nist(std::string_view content, const std::string& file,
                                     const MeasurementOptions& options);

// "src_z src_a view_z view_a 532nm 1064nm ...": reflectance factors, pi f_r; one measurement a wavelength.
[[nodiscard]] Measurements read_factors(std::string_view content, const std::string& file,
                                        const MeasurementOptions& options);

// What a file is by its content.
[[nodiscard]] bool is_alta(std::string_view content);
[[nodiscard]] bool is_zemax(std::string_view content);
[[nodiscard]] bool is_fred(std::string_view content);
[[nodiscard]] bool is_merl(std::string_view content);
[[nodiscard]] bool is_lumos(std::string_view content);
[[nodiscard]] bool is_nist(std::string_view content);
[[nodiscard]] bool is_factors(std::string_view content);
// Also of a table that lacks what read_csv() needs, which it then says.
[[nodiscard]] bool is_csv(std::string_view content);

}  // namespace lrcs
