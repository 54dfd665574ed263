#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace lrcs {

// The length units a user may write: nm um mm cm dm m km inch in ft mil. In the order to list them in a message.
// Micrometres may also be written with the Greek letter.
[[nodiscard]] const std::vector<std::string>& length_units();

// Metres in one unit [m]. Throws std::invalid_argument that lists the units, for a name that is none.
[[nodiscard]] double metres_in(std::string_view unit);

// "1.06 um", "1064nm" -> [m].
// domain: finite, positive, with a unit; else std::invalid_argument that says what was expected.
// error: decimal units are read to the nearest double ("1.06 um" is 1.06e-6 exactly); inch, ft, mil: half an ulp more.
[[nodiscard]] double length_from_text(std::string_view text);

// Metres -> "1.06 um", the shortest number that length_from_text reads back to the same double; in metres where the
// unit has none. domain: a finite positive length and a unit of length_units().
[[nodiscard]] std::string text_of_length(double metres, std::string_view unit);

}  // namespace lrcs
