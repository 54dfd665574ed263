#include "report/shown_returns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lrcs {
namespace {

// shape of values: rows x facets.
std::vector<std::uint8_t> first_row_and_differences(const std::vector<std::vector<std::uint8_t>>& values) {
  if (values.empty()) return {};
  std::vector<std::uint8_t> coded = values[0];
  for (std::size_t facet = 0; facet < values[0].size(); ++facet)
    for (std::size_t row = 1; row < values.size(); ++row)
      coded.push_back(static_cast<std::uint8_t>(values[row][facet] - values[row - 1][facet]));
  return coded;
}

}  // namespace

ShownReturns::ShownReturns(const ShownTarget& shown, std::vector<std::size_t> rows)
    : shown_(shown), rows_(std::move(rows)), per_area_(rows_.size()), seen_(rows_.size()) {}

std::size_t ShownReturns::place_of(std::size_t row) const {
  return static_cast<std::size_t>(std::lower_bound(rows_.begin(), rows_.end(), row) - rows_.begin());
}

bool ShownReturns::wants(std::size_t row) const {
  return std::binary_search(rows_.begin(), rows_.end(), row);
}

void ShownReturns::take(std::size_t row, const std::vector<double>& facet_sigma,
                        const std::vector<double>& seen_fraction, const std::vector<double>& facet_area) {
  std::vector<double> sigma(shown_.size(), 0.0), seen(shown_.size(), 0.0);
  for (std::size_t k = 0; k < shown_.shown_of.size(); ++k) {
    sigma[shown_.shown_of[k]] += facet_sigma[k];
    seen[shown_.shown_of[k]] += seen_fraction[k] * facet_area[k];
  }
  std::vector<float> per_area(shown_.size(), 0.0F), seen_part(shown_.size(), 0.0F);
  for (std::size_t k = 0; k < shown_.size(); ++k) {
    const std::uint32_t of = shown_.value_of[k];
    if (!(shown_.area[of] > 0.0)) continue;
    per_area[k] = static_cast<float>(sigma[of] / shown_.area[of]);
    seen_part[k] = static_cast<float>(std::min(1.0, seen[of] / shown_.area[of]));
    brightest_ = std::max<double>(brightest_, per_area[k]);
  }
  if (!wants(row)) return;
  per_area_[place_of(row)] = std::move(per_area);
  seen_[place_of(row)] = std::move(seen_part);
}

std::vector<std::uint8_t> ShownReturns::levels() const {
  const auto level_of = [&](float value, float seen) -> std::uint8_t {
    if (seen <= 0.0F) return 0;
    const double decibels =
        value > 0.0F ? 10.0 * std::log10(value / brightest_) : -std::numeric_limits<double>::infinity();
    return static_cast<std::uint8_t>(std::lround(std::clamp(1.0 + (decibels - floor_db) / step_db, 1.0, 255.0)));
  };
  std::vector<std::vector<std::uint8_t>> levels(rows_.size());
  for (std::size_t row = 0; row < rows_.size(); ++row)
    for (std::size_t k = 0; k < per_area_[row].size(); ++k)
      levels[row].push_back(level_of(per_area_[row][k], seen_[row][k]));
  return first_row_and_differences(levels);
}

std::vector<std::uint8_t> ShownReturns::seen() const {
  std::vector<std::vector<std::uint8_t>> parts(rows_.size());
  for (std::size_t row = 0; row < rows_.size(); ++row)
    for (const float part : seen_[row])
      parts[row].push_back(static_cast<std::uint8_t>(std::max(part > 0.0F ? 1L : 0L, std::lround(255.0F * part))));
  return first_row_and_differences(parts);
}

}  // namespace lrcs
