#pragma once
#include <string>
#include <vector>

#include "bench/summary.h"

namespace lrcs {

// The slope of log y over log x: the exponent p of the power law y ~ x^p that fits best.
// domain: at least two different x; all positive.
[[nodiscard]] double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

// Time against facets, of every method that ran on at least two of the targets. value: the table as printed; "" if none
// did.
[[nodiscard]] std::string cost_growth_text(const std::vector<Summary>& of_like_targets);

}  // namespace lrcs
