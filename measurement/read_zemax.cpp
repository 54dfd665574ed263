#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/direction.h"
#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/comment_wavelength.h"
#include "measurement/convention.h"
#include "measurement/measured_numbers.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

constexpr std::string_view keywords =
    "Source, Symmetry, SpectralContent, ScatterType, SampleRotation, AngleOfIncidence, ScatterAzimuth, ScatterRadial, "
    "Monochrome or DataBegin";

// The direction that lies `radial` from the specular ray of incidence `aoi`, turned by `azimuth` around it, 0 toward
// the normal [deg]. The transmitter is at azimuth 0, n = +z.
Vec3 scattered(double aoi, double radial, double azimuth) {
  const auto [cos_i, sin_i] = cos_sin_deg(aoi);
  const auto [cos_r, sin_r] = cos_sin_deg(radial);
  const auto [cos_a, sin_a] = cos_sin_deg(azimuth);
  const Vec3 specular(-sin_i, 0.0, cos_i);
  const Vec3 toward_normal(cos_i, 0.0, sin_i);
  return cos_r * specular + sin_r * (cos_a * toward_normal + sin_a * Vec3::UnitY());
}

Vec3 transmitter(double aoi) {
  const auto [cos_i, sin_i] = cos_sin_deg(aoi);
  return {sin_i, 0.0, cos_i};
}

class ZemaxReader {
 public:
  ZemaxReader(std::string_view content, const std::string& file)
      : content_(content), scanner_(content, file), builder_(file, "Zemax BSDF") {
    builder_.set_angles_in_degrees();
  }

  BrdfMeasurement read(const MeasurementOptions& options) {
    note_convention(options);
    while (read_statement(next_keyword())) scanner_.next_line();
    for (const double aoi : incidences_) read_incidence(aoi);
    const std::string_view end = next_keyword();
    if (end != "DataEnd") scanner_.fail_expected("'DataEnd'", end);
    const std::string_view more = next_keyword();
    if (!more.empty()) scanner_.fail_expected("the end of the file after 'DataEnd'", more);
    take_wavelength_of_comments(content_, builder_);
    return builder_.finish();
  }

 private:
  void note_convention(const MeasurementOptions& options) {
    if (options.azimuth_of_specular)
      throw InputError(scanner_.place(),
                       fmt::format("the format counts angles from the specular ray, asked for was an azimuth of "
                                   "specular of {} deg, expected none",
                                   *options.azimuth_of_specular));
    Convention convention = fixed(180, false, scanner_.place(), options);
    convention.azimuth_note = "angles counted from the specular ray, azimuth 0 toward the normal (the file says so)";
    convention.apply(builder_);
  }

  // The first word of the next line that has one.
  std::string_view next_keyword() { return scanner_.next_word(); }

  // False at DataBegin.
  bool read_statement(std::string_view keyword) {
    if (keyword == "DataBegin") return begin_data();
    if (keyword == "Source" || keyword == "Monochrome") return true;
    if (keyword == "Symmetry")
      require_word({"PlaneSymmetrical", "Asymmetrical", "ASymmetrical", "Asymmetrical4D", "ASymmetrical4D"});
    else if (keyword == "SpectralContent")
      require_word({"Monochrome"});
    else if (keyword == "ScatterType")
      require_word({"BRDF"});
    else if (keyword == "SampleRotation")
      require_one_rotation();
    else if (keyword == "AngleOfIncidence")
      incidences_ = read_list(0.0, 90.0);
    else if (keyword == "ScatterAzimuth")
      azimuths_ = read_list(-360.0, 360.0);
    else if (keyword == "ScatterRadial")
      radials_ = read_list(0.0, 180.0);
    else
      scanner_.fail_expected(keywords, keyword);
    return true;
  }

  bool begin_data() {
    const auto require = [&](const std::vector<double>& list, std::string_view name) {
      if (list.empty()) scanner_.fail(fmt::format("expected '{}' before the data", name));
    };
    require(incidences_, "AngleOfIncidence");
    require(azimuths_, "ScatterAzimuth");
    require(radials_, "ScatterRadial");
    return false;
  }

  void require_word(const std::vector<std::string_view>& read) {
    const std::string_view word = scanner_.word();
    if (std::find(read.begin(), read.end(), word) != read.end()) return;
    scanner_.fail_expected(fmt::format("{} (nothing else is read)", read.front()), word);
  }

  void require_one_rotation() {
    const std::int64_t count = scanner_.integer();
    if (count != 1) scanner_.fail(fmt::format("expected 1 sample rotation (more are not read), found {}", count));
    static_cast<void>(scanner_.number_in(scanner_.next_word()));
  }

  // "N", then N angles in degrees.
  std::vector<double> read_list(double least, double most) {
    const std::int64_t count = scanner_.integer();
    if (count < 1 || count > static_cast<std::int64_t>(scanner_.left()))
      scanner_.fail(fmt::format("expected a number of angles that the file can hold, found {}", count));
    std::vector<double> list;
    for (std::int64_t k = 0; k < count; ++k) {
      list.push_back(measured_number(scanner_, scanner_.next_word()));
      if (list.back() < least || list.back() > most)
        scanner_.fail(fmt::format("expected an angle from {} to {} deg, found {}", least, most, list.back()));
    }
    return list;
  }

  void read_incidence(double aoi) {
    const std::string_view keyword = next_keyword();
    if (keyword != "TIS") scanner_.fail_expected("'TIS'", keyword);
    scanner_.number();
    for (const double azimuth : azimuths_) read_azimuth(aoi, azimuth);
  }

  void read_azimuth(double aoi, double azimuth) {
    for (std::size_t k = 0; k < radials_.size(); ++k) {
      const std::string_view text = k == 0 ? scanner_.next_word() : scanner_.word();
      const double value = not_negative(scanner_, text, "a value");
      if (is_repeated(radials_[k], azimuth, value)) continue;
      add(aoi, radials_[k], azimuth, value);
    }
    const std::string_view more = scanner_.word();
    if (!more.empty()) scanner_.fail_expected(fmt::format("the end of a row of {} values", radials_.size()), more);
  }

  // Of the specular ray itself every azimuth states the same value.
  bool is_repeated(double radial, double azimuth, double value) {
    if (radial != 0.0) return false;
    if (azimuth == azimuths_.front()) at_specular_ = value;
    return azimuth != azimuths_.front() && value == at_specular_;
  }

  void add(double aoi, double radial, double azimuth, double value) {
    if (value == 0.0) return builder_.leave_out("of 0, not measured in this format,");
    builder_.add(transmitter(aoi), scattered(aoi, radial, azimuth), value, scanner_.line());
  }

  std::string_view content_;
  TextScanner scanner_;
  MeasurementBuilder builder_;
  std::vector<double> incidences_, azimuths_, radials_;  // [deg]
  double at_specular_ = 0.0;
};

}  // namespace

bool is_zemax(std::string_view content) {
  TextScanner scanner(content, "");
  do {
    const std::string_view word = scanner.word();
    if (word == "ScatterType" || word == "ScatterAzimuth" || word == "DataBegin") return true;
  } while (scanner.next_line());
  return false;
}

Measurements read_zemax(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  return {ZemaxReader(content, file).read(options)};
}

}  // namespace lrcs
