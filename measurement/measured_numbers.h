#pragma once
#include <numbers>
#include <string_view>

#include "base/text_scanner.h"

namespace lrcs {

// A zenith angle this close to 90 deg is taken for 90 deg: what is left of seven digits.
inline constexpr double grazing_width = 1e-7;  // [rad]

enum class AngleUnit { degrees, radians };

// A number that may stand in a file of measured BRDFs: finite, at most 1e100 in size.
[[nodiscard]] double measured_number(const TextScanner& scanner, std::string_view text);

// An angle from the normal [rad]; negative: on the other side of it. domain: at most 90 deg in size.
[[nodiscard]] double zenith_angle(const TextScanner& scanner, std::string_view text, AngleUnit unit);

// An azimuth [rad]. domain: at most two turns in size.
[[nodiscard]] double azimuth_angle(const TextScanner& scanner, std::string_view text, AngleUnit unit);

// A number that must not be negative. `what` it is, for the message.
[[nodiscard]] double not_negative(const TextScanner& scanner, std::string_view text, std::string_view what);

}  // namespace lrcs
