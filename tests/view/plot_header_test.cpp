#include "view/plot_header.h"

#include <gtest/gtest.h>

namespace lrcs {
namespace {

double height_of(const PlotHeader& header) {
  Canvas canvas(1600, 600);
  return 600.0 - draw_header(canvas, header);
}

TEST(PlotHeader, BreaksANoteAtItsLineBreaks) {
  const double one = height_of({"title", "note", {}}), none = height_of({"title", "", {}});
  EXPECT_GT(one, none);
  EXPECT_DOUBLE_EQ(height_of({"title", "note\nnote", {}}) - one, one - none);
  EXPECT_DOUBLE_EQ(height_of({"title", "\nnote\n", {}}), one);
  const double two_titles = height_of({"title\ntitle", "", {}}) - none;
  EXPECT_DOUBLE_EQ(two_titles, none - height_of({"", "", {}}));
}

TEST(PlotHeader, BreaksANoteBetweenWordsWhereItIsTooWide) {
  std::string note = "word";
  for (int k = 0; k < 40; ++k) note += " word";
  const double none = height_of({"", "", {}}), one = height_of({"", "word", {}}) - none;
  const double needed = text_size(note, note_font).width / 1600.0;
  EXPECT_GE(height_of({"", note, {}}) - none, one * needed);
  EXPECT_LE(height_of({"", note, {}}) - none, one * (needed + 2.0));
}

TEST(PlotHeader, BreaksATitleThatIsTooWideEvenWithoutBlanks) {
  const double none = height_of({"", "", {}}), one = height_of({"title", "", {}}) - none;
  EXPECT_DOUBLE_EQ(height_of({std::string(60, 'x') + ": model", "", {}}) - none, 2.0 * one);
}

TEST(PlotHeader, LeavesOutTheMiddleOfATitleOfMoreThanTwoLines) {
  const double none = height_of({"", "", {}}), one = height_of({"title", "", {}}) - none;
  std::string letters;  // of two bytes
  for (int k = 0; k < 300; ++k) letters += "é";
  EXPECT_DOUBLE_EQ(height_of({std::string(1000, 'x'), "", {}}) - none, 2.0 * one);
  EXPECT_DOUBLE_EQ(height_of({letters, "", {}}) - none, 2.0 * one);
}

TEST(PlotHeader, StartsARowOfTheLegendWhereToldTo) {
  LegendEntry second{"second", {}};
  const double one = height_of({"", "", {{"first", {}}, second}});
  second.starts_row = true;
  EXPECT_GT(height_of({"", "", {{"first", {}}, second}}), one);
}

}  // namespace
}  // namespace lrcs
