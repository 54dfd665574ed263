#pragma once
#include <string>
#include <vector>

#include "cli/past_run.h"
#include "report/shown_returns.h"
#include "report/shown_target.h"

namespace lrcs {

// How the run went, as JSON of the same. error: InputError where the manifest does not say so.
[[nodiscard]] std::string report_run_facts(const PastRun& run, const std::filesystem::path& manifest);

// The numbers of a report's page, but for its facets: JSON by report/web/PAYLOAD.md.
// part_sigma: of every row [m^2], a list a row, one a part.
[[nodiscard]] std::string report_json(const PastRun& run, const std::string& run_facts,
                                      const std::vector<std::vector<double>>& part_sigma, const ShownTarget& shown,
                                      const ShownReturns& returns);

// Its facets.
[[nodiscard]] std::vector<std::uint8_t> report_facets(const PastRun& run, const ShownTarget& shown,
                                                      const ShownReturns& returns);

}  // namespace lrcs
