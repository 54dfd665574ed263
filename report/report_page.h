#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lrcs {

// The page of a report without its numbers: HTML, styles and scripts in one (report/web).
[[nodiscard]] std::string_view page_template();

// The page with its numbers in it; what they are: report/web/PAYLOAD.md.
[[nodiscard]] std::string report_page(const std::string& json, const std::vector<std::uint8_t>& facets);

}  // namespace lrcs
