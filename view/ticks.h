#pragma once
#include <string>
#include <vector>

namespace lrcs {

// A step for the marks of an axis: at most `most` steps fit into `span`.
// nice_step: 1, 2 or 5 times a power of ten. angle_step: the same below 10; above, 10 15 30 45 90 180 [deg].
// domain: span finite and > 0, most > 0.
[[nodiscard]] double nice_step(double span, int most);
[[nodiscard]] double angle_step(double span_deg, int most);

// The whole multiples of `step` in [low, high], rising.
[[nodiscard]] std::vector<double> multiples(double low, double high, double step);

// A number for a label, exact to the digits of `step`, with a typographic minus: "-40" as "−40", "0.25".
[[nodiscard]] std::string tick_label(double value, double step);

// The same with `digits` significant ones.
[[nodiscard]] std::string number_label(double value, int digits);

}  // namespace lrcs
