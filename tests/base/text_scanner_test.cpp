#include "base/text_scanner.h"

#include <gtest/gtest.h>

#include <vector>

namespace lrcs {
namespace {

std::vector<std::string> cells_of(std::string_view line) {
  TextScanner scanner(line, "a.csv");
  std::vector<std::string> cells;
  while (const auto cell = scanner.cell()) cells.emplace_back(*cell);
  return cells;
}

using Cells = std::vector<std::string>;

TEST(TextScanner, SplitsALineIntoCellsAtItsCommas) {
  EXPECT_EQ(cells_of("a, b ,\"c\"\n d"), (Cells{"a", "b", "c"}));
  EXPECT_EQ(cells_of("a,,b,"), (Cells{"a", "", "b", ""}));
  EXPECT_EQ(cells_of(",\r\n"), (Cells{"", ""}));
  EXPECT_EQ(cells_of(""), Cells{});
  EXPECT_EQ(cells_of("\n"), Cells{});
}

TEST(TextScanner, KnowsTheColumnOfACell) {
  TextScanner scanner("1\n2, 3,\" x\"", "a.csv");
  scanner.next_line();
  scanner.cell();
  EXPECT_EQ(scanner.place().column, 1);
  scanner.cell();
  EXPECT_EQ(scanner.place().column, 4);
  const auto cell = scanner.cell();
  EXPECT_EQ(scanner.place().text(), "a.csv:2:7");
  EXPECT_EQ(cell, " x");
}

}  // namespace
}  // namespace lrcs
