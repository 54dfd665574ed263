#pragma once
#include <cstdint>
#include <vector>

#include "report/shown_target.h"

namespace lrcs {

// What shown facets return in some rows of a sweep, in a byte each.
class ShownReturns {
 public:
  // rows: those of the sweep that are to be shown. Both must outlive this.
  ShownReturns(const ShownTarget& shown, std::vector<std::size_t> rows);

  // A row of the sweep; each once, in any order, one at a time. Of rows that are not shown only the brightest facet
  // counts. shape: one a facet of the target.
  void take(std::size_t row, const std::vector<double>& facet_sigma, const std::vector<double>& seen_fraction,
            const std::vector<double>& facet_area);
  [[nodiscard]] bool wants(std::size_t row) const;
  [[nodiscard]] const std::vector<std::size_t>& rows() const { return rows_; }

  // In decibels below the shown facet that returns most per area in any row.
  static constexpr double floor_db = -63.5, step_db = 0.25;
  [[nodiscard]] double brightest() const { return brightest_; }  // [m^2/m^2]
  // 0: not lit and seen; 1: floor_db or less; k: floor_db + (k - 1) step_db, to the nearest.
  // shape: facets, the first row; facets x (rows - 1), differences modulo 256 (report/web/PAYLOAD.md).
  [[nodiscard]] std::vector<std::uint8_t> levels() const;
  // Seen part of the area, 255: all of it; 0: nothing, else at least 1. shape: the same.
  [[nodiscard]] std::vector<std::uint8_t> seen() const;

 private:
  [[nodiscard]] std::size_t place_of(std::size_t row) const;

  const ShownTarget& shown_;
  std::vector<std::size_t> rows_;
  std::vector<std::vector<float>> per_area_;  // a list a row, one a shown facet
  std::vector<std::vector<float>> seen_;
  double brightest_ = 0.0;
};

}  // namespace lrcs
