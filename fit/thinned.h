#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "measurement/brdf_measurement.h"

namespace lrcs {

// About `count` of the samples, whose weighted sums stand for those of all: the fifth part of `count` that has the
// largest w (f_r cos theta_r)^2, with their weights; and of as many even stretches of the others as remain, in file
// order, one at random each with the weight of its stretch. A scan's own period has no say, a narrow lobe is not
// missed. shape: all samples where they are not more than `count`. laws: the same for the same seed.
[[nodiscard]] std::vector<BrdfSample> thinned(const std::vector<BrdfSample>& samples, std::size_t count,
                                              std::uint64_t seed);

}  // namespace lrcs
