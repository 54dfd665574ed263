#include <fmt/format.h>

#include <numbers>
#include <utility>

#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/comment_wavelength.h"
#include "measurement/convention.h"
#include "measurement/measured_numbers.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

class FredReader {
 public:
  FredReader(std::string_view content, const std::string& file)
      : content_(content), scanner_(content, file), builder_(file, "FRED BSDF data") {}

  BrdfMeasurement read(const MeasurementOptions& options) {
    next_row();
    read_type();
    fixed(0, false, scanner_.place(), options).apply(builder_);
    if (!next_row()) scanner_.fail("expected 'format', found the end of the file");
    read_format();
    take_wavelength_of_comments(content_, builder_);
    while (next_row()) read_numbers();
    require_values();
    return builder_.finish();
  }

 private:
  // Goes to the next line that holds words; at first to the first.
  bool next_row() {
    if (std::exchange(begun_, true) && !scanner_.next_line()) return false;
    while (!holds_cells(scanner_)) {
      if (!scanner_.next_line()) return false;
    }
    return true;
  }

  void read_type() {
    scanner_.word();
    const std::string_view type = scanner_.word();
    if (type != "bsdf_data") scanner_.fail_expected("bsdf_data", type);
  }

  void read_format() {
    const std::string_view keyword = scanner_.word();
    if (keyword != "format") scanner_.fail_expected("'format'", keyword);
    bool says_angles = false;
    for (auto word = scanner_.word(); !word.empty(); word = scanner_.word()) {
      says_angles = says_angles || word.starts_with("angles=");
      read_format_word(word);
    }
    if (!says_angles) scanner_.fail("the format says no unit of angles, expected angles=deg or angles=rad");
    if (unit_ == AngleUnit::degrees) builder_.set_angles_in_degrees();
  }

  void read_format_word(std::string_view word) {
    if (word == "bsdf=value") return;
    if (word == "angles=deg" || word == "angles=rad") {
      unit_ = word == "angles=deg" ? AngleUnit::degrees : AngleUnit::radians;
    } else if (word.starts_with("scale=")) {
      scale_ = not_negative(scanner_, word.substr(6), "a scale");
      if (scale_ != 1.0) builder_.note(fmt::format("values times the scale {}", scale_));
    } else {
      scanner_.fail_expected("angles=deg, angles=rad, bsdf=value or scale=NUMBER", word);
    }
  }

  // "AOI azimuth" of what follows, or "theta phi value".
  void read_numbers() {
    TextScanner ahead = scanner_;
    int count = 0;
    while (!ahead.word().empty()) ++count;
    if (count == 2) return read_incidence();
    if (count != 3)
      scanner_.fail(fmt::format("expected 2 numbers, AOI and azimuth, or 3, theta, phi and value, found {}", count));
    if (!has_incidence_) scanner_.fail("expected 2 numbers, AOI and azimuth, before the first values");
    read_value();
  }

  void read_incidence() {
    require_values();
    theta_i_ = zenith_angle(scanner_, scanner_.word(), unit_);
    if (azimuth_angle(scanner_, scanner_.word(), unit_) != 0.0)
      scanner_.fail("expected the azimuth 0 of incidence, others are not read");
    has_incidence_ = true;
    has_values_ = false;
  }

  // Of the incidence read last: else it may be the rest of a row that was cut off.
  void require_values() const {
    if (has_incidence_ && !has_values_)
      scanner_.fail("expected 3 numbers, theta, phi and value, after AOI and azimuth in the row before");
  }

  void read_value() {
    has_values_ = true;
    BrdfSample sample;
    sample.line = scanner_.line();
    sample.theta_i = theta_i_;
    sample.theta_r = zenith_angle(scanner_, scanner_.word(), unit_);
    sample.phi = azimuth_angle(scanner_, scanner_.word(), unit_) + std::numbers::pi;
    sample.f_r = scale_ * not_negative(scanner_, scanner_.word(), "a value");
    builder_.add(sample);
  }

  std::string_view content_;
  TextScanner scanner_;
  MeasurementBuilder builder_;
  AngleUnit unit_ = AngleUnit::degrees;
  double scale_ = 1.0;
  double theta_i_ = 0.0;
  bool has_incidence_ = false, has_values_ = false;
  bool begun_ = false;
};

}  // namespace

bool is_fred(std::string_view content) {
  TextScanner scanner(content, "");
  return scanner.next_word() == "type" && scanner.word().starts_with("bsdf");
}

Measurements read_fred(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  return {FredReader(content, file).read(options)};
}

}  // namespace lrcs
