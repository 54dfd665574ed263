#pragma once

namespace lrcs {

// A computed quantity and a bound on its error: |value - truth| <= bound. Both in the unit of the quantity.
struct Estimate {
  double value = 0.0;
  double bound = 0.0;
};

}  // namespace lrcs
