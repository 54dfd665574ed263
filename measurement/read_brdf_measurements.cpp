#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/digest.h"
#include "base/gunzip.h"
#include "base/input_error.h"
#include "measurement/brdf_measurement.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

constexpr std::uintmax_t largest_file = 256U << 20U;  // [B]

constexpr std::string_view readable =
    "expected measured BRDFs as CSV with the header theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr[,weight], or as ALTA, "
    "Zemax BSDF, FRED, MERL or a table of named angles";

struct Format {
  bool (*is)(std::string_view);
  Measurements (*read)(std::string_view, const std::string&, const MeasurementOptions&);
};

// In the order of asking: what the later would also take comes first.
constexpr std::array formats{Format{is_alta, read_alta},   Format{is_fred, read_fred}, Format{is_zemax, read_zemax},
                             Format{is_lumos, read_lumos}, Format{is_nist, read_nist}, Format{is_factors, read_factors},
                             Format{is_csv, read_csv}};

void require_readable(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const Place place{file.string()};
  if (!std::filesystem::exists(status)) throw InputError(place, "cannot be read: " + error.message());
  if (std::filesystem::is_directory(status)) throw InputError(place, "is a folder, expected a file");
  if (!std::filesystem::is_regular_file(status)) throw InputError(place, "is no regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw InputError(place, "cannot be read: " + error.message());
  if (size > largest_file)
    throw InputError(place, fmt::format("has {} bytes, expected at most {}", size, largest_file));
}

void require_text(std::string_view content, const std::string& file) {
  const Place place{file};
  if (content.empty()) throw InputError(place, fmt::format("is empty, {}", readable));
  if (content.starts_with("\xfe\xff") || content.starts_with("\xff\xfe"))
    throw InputError(place, "is UTF-16 text, expected UTF-8 or ASCII");
  if (content.find('\0') != std::string_view::npos)
    throw InputError(place, fmt::format("is binary, in no format known here, {}", readable));
}

void require_options(const MeasurementOptions& options, const std::string& file) {
  const auto azimuth = options.azimuth_of_specular;
  if (azimuth && *azimuth != 0 && *azimuth != 180)
    throw InputError(Place{file},
                     fmt::format("azimuth of specular: expected 180 or 0 deg, asked for was {}", *azimuth));
}

}  // namespace

std::vector<BrdfMeasurement> read_brdf_measurements(const std::filesystem::path& file,
                                                    const MeasurementOptions& options) {
  require_readable(file);
  require_options(options, file.string());
  std::string bytes = content_of_file(file);
  if (is_gzip(bytes)) bytes = gunzip(bytes, file.string());
  std::string_view content = bytes;
  if (is_merl(content)) return read_merl(content, file.string(), options);
  if (content.starts_with("\xef\xbb\xbf")) content.remove_prefix(3);  // UTF-8's byte order mark
  require_text(content, file.string());
  for (const Format& format : formats) {
    if (format.is(content)) return format.read(content, file.string(), options);
  }
  throw InputError(Place{file.string()}, fmt::format("is in no format known here, {}", readable));
}

}  // namespace lrcs
