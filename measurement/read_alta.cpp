#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text_scanner.h"
#include "measurement/column_rows.h"
#include "measurement/comment_wavelength.h"
#include "measurement/convention.h"
#include "measurement/half_difference.h"
#include "measurement/measured_numbers.h"
#include "measurement/measurement_builder.h"
#include "measurement/read_formats.h"

namespace lrcs {
namespace {

constexpr std::string_view read_params = "ISOTROPIC_TL_TV_PROJ_DPHI, ISOTROPIC_TV_TL_DPHI or RUSIN_TH_TD_PD";
constexpr std::string_view read_outputs = "INV_STERADIAN or INV_STERADIAN_COSINE_FACTOR";

enum class Param { tl_tv_projected, tv_tl_dphi, half_difference };

constexpr std::array param_names{std::pair{"ISOTROPIC_TL_TV_PROJ_DPHI", Param::tl_tv_projected},
                                 std::pair{"ISOTROPIC_TV_TL_DPHI", Param::tv_tl_dphi},
                                 std::pair{"RUSIN_TH_TD_PD", Param::half_difference}};

Param read_param(TextScanner& words) {
  const std::string_view name = words.word();
  for (const auto& [known, param] : param_names) {
    if (name == known) return param;
  }
  words.fail_expected(read_params, name);
}

bool read_has_cosine(TextScanner& words) {
  const std::string_view name = words.word();
  if (name != "INV_STERADIAN" && name != "INV_STERADIAN_COSINE_FACTOR") words.fail_expected(read_outputs, name);
  return name == "INV_STERADIAN_COSINE_FACTOR";
}

void require_word(TextScanner& words, std::string_view count, std::string_view what) {
  const std::string_view found = words.word();
  if (found != count) words.fail_expected(what, found);
}

// The header: lines "#KEYWORD ...". Other keywords are words for people.
struct AltaHeader {
  std::optional<Said<Param>> param;
  std::optional<Said<bool>> value_has_cosine;
  bool has_dimensions = false;
  int unread_columns = 0;

  void read(TextScanner scanner, const std::string& file) {
    do {
      TextScanner line = scanner;
      std::string text(line.rest_of_line());
      if (!text.starts_with('#')) continue;
      text.front() = ' ';  // the column stays
      read_keyword(TextScanner(text, file, scanner.line()));
    } while (scanner.next_line());
    if (!has_dimensions) scanner.fail("no #DIM in the header, expected #DIM 3 1");
    if (!param) scanner.fail(fmt::format("no #PARAM_IN in the header, expected {}", read_params));
    if (!value_has_cosine) scanner.fail(fmt::format("no #PARAM_OUT in the header, expected {}", read_outputs));
  }

 private:
  void read_keyword(TextScanner words) {
    const std::string_view keyword = words.word();
    if (keyword == "DIM") read_dimensions(words);
    if (keyword == "VS") read_segments(words);
    if (keyword == "FORMAT") require_word(words, "text", "text data (binary ones are not read)");
    if (keyword == "PARAM_IN") {
      const Param found = read_param(words);
      take_said(param, found, words, keyword);
    }
    if (keyword == "PARAM_OUT") {
      const bool found = read_has_cosine(words);
      take_said(value_has_cosine, found, words, keyword);
    }
  }

  void read_dimensions(TextScanner& words) {
    require_word(words, "3", "3 angles");
    require_word(words, "1", "1 channel (more are not read)");
    has_dimensions = true;
  }

  // A kind of interval around each value takes as many columns more as its number says.
  void read_segments(TextScanner& words) {
    const std::int64_t kind = words.integer();
    if (kind < 0 || kind > 2) words.fail(fmt::format("expected VS 0, 1 or 2, found {}", kind));
    unread_columns = static_cast<int>(kind);
  }
};

class AltaRows {
 public:
  AltaRows(TextScanner scanner, const AltaHeader& header, MeasurementBuilder& builder)
      : scanner_(std::move(scanner)), header_(header), builder_(builder) {}

  void read() {
    do {
      if (holds_cells(scanner_)) read_row();
    } while (scanner_.next_line());
  }

 private:
  void read_row() {
    switch (header_.param->value) {
      case Param::tl_tv_projected:
        return read_projected();
      case Param::tv_tl_dphi:
        return read_angles();
      case Param::half_difference:
        return read_half_difference();
    }
  }

  // theta_r (cos phi, sin phi).
  void read_projected() {
    BrdfSample sample;
    sample.theta_i = zenith();
    const double x = zenith();
    const double y = zenith();
    sample.theta_r = std::hypot(x, y);
    if (sample.theta_r > std::numbers::pi / 2.0 + grazing_width)
      scanner_.fail(fmt::format(
          "expected an angle from the normal of at most 1.5708 rad, found the projections of {:.6g}", sample.theta_r));
    sample.phi = std::atan2(y, x);
    add(sample);
  }

  void read_angles() {
    BrdfSample sample;
    sample.theta_r = zenith();
    sample.theta_i = zenith();
    sample.phi = azimuth();
    add(sample);
  }

  void read_half_difference() {
    const double theta_h = zenith();
    const double theta_d = zenith();
    const auto [view, light] = directions_of_half_difference(theta_h, theta_d, azimuth());
    const double value = take_value();
    builder_.add(light, view, value, scanner_.line());
  }

  double zenith() { return zenith_angle(scanner_, scanner_.word(), AngleUnit::radians); }
  double azimuth() { return azimuth_angle(scanner_, scanner_.word(), AngleUnit::radians); }

  void add(BrdfSample sample) {
    sample.f_r = take_value();
    sample.line = scanner_.line();
    builder_.add(sample);
  }

  double take_value() {
    const double value = not_negative(scanner_, scanner_.word(), "a value");
    for (int k = 0; k < header_.unread_columns; ++k) scanner_.number();
    const std::string_view more = scanner_.word();
    if (!more.empty()) scanner_.fail_expected(fmt::format("the end of a row of {}", 4 + header_.unread_columns), more);
    return value;
  }

  TextScanner scanner_;
  const AltaHeader& header_;
  MeasurementBuilder& builder_;
};

}  // namespace

bool is_alta(std::string_view content) {
  TextScanner scanner(content, "");
  do {
    TextScanner line = scanner;
    const std::string_view text = line.rest_of_line();
    if (text.starts_with("#DIM ") || text.starts_with("#PARAM_IN") || text.starts_with("#PARAM_OUT")) return true;
    if (!text.empty() && !text.starts_with('#')) return false;
  } while (scanner.next_line());
  return false;
}

Measurements read_alta(std::string_view content, const std::string& file, const MeasurementOptions& options) {
  const TextScanner scanner(content, file);
  AltaHeader header;
  header.read(scanner, file);
  const SaidConvention said{Said<int>{180, header.param->place}, header.value_has_cosine};
  MeasurementBuilder builder(file, "ALTA");
  settled(said, options).apply(builder);
  if (header.unread_columns > 0) builder.note(fmt::format("{} columns of intervals not read", header.unread_columns));
  take_wavelength_of_comments(content, builder);
  AltaRows(scanner, header, builder).read();
  return {builder.finish()};
}

}  // namespace lrcs
