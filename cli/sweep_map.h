#pragma once
#include <optional>
#include <vector>

#include "lrcs/sweep.h"
#include "view/direction_map.h"

namespace lrcs {

// A sweep over both angles of the transmitter as a grid of directions. Of rows with the same angles the last one
// counts. None where one angle is always the same, or where more than half of the grid's directions are missing.
[[nodiscard]] std::optional<DirectionMap> direction_map(const std::vector<SweepRow>& rows);

}  // namespace lrcs
