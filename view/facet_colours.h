#pragma once
#include <vector>

#include "mesh/facet_mesh.h"
#include "view/colour.h"
#include "view/facet_result.h"

namespace lrcs {

inline constexpr double darkest_db = -40.0;             // below the brightest facet, still told apart [dB]
inline constexpr Colour unseen_grey{0.83, 0.83, 0.83};  // facets not lit and seen

// sigma / area of each facet in dB below the largest: <= 0; minus infinity where sigma or area is 0.
[[nodiscard]] std::vector<double> decibels_below_brightest(const FacetMesh& mesh, const FacetResult& result);

// The colour of each facet, by the value above; darkest_db and less look the same.
[[nodiscard]] std::vector<Colour> facet_colours(const FacetMesh& mesh, const FacetResult& result);

}  // namespace lrcs
