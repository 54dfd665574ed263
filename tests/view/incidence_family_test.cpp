#include "view/incidence_family.h"

#include <gtest/gtest.h>

namespace lrcs {
namespace {

using Indices = std::vector<std::size_t>;

TEST(SpreadChoice, TakesBothEndsAndEvenSteps) {
  EXPECT_EQ(spread_choice(15, 8), (Indices{0, 2, 4, 6, 8, 10, 12, 14}));
  EXPECT_EQ(spread_choice(9, 3), (Indices{0, 4, 8}));
  for (std::size_t count = 9; count < 200; ++count) {
    const Indices chosen = spread_choice(count, 8);
    EXPECT_EQ(chosen.size(), 8U);
    EXPECT_EQ(chosen.back(), count - 1);
    for (std::size_t k = 1; k < chosen.size(); ++k) EXPECT_GT(chosen[k], chosen[k - 1]) << count;
  }
}

TEST(SpreadChoice, TakesAllWhereThereAreNoMore) {
  EXPECT_EQ(spread_choice(3, 8), (Indices{0, 1, 2}));
  EXPECT_EQ(spread_choice(0, 8), Indices{});
}

TEST(ChoiceNote, SpeaksOnlyOfWhatIsLeftOut) {
  EXPECT_EQ(choice_note(8, 23), "8 of 23 incidence angles are drawn");
  EXPECT_EQ(choice_note(3, 3), "");
}

TEST(FamilyPen, TellsAnglesByColourAndMaterialsByDashes) {
  for (std::size_t m = 1; m < most_materials_in_a_plot; ++m) {
    EXPECT_EQ(family_pen(2, m).colour.red, family_pen(2, 0).colour.red);
    for (std::size_t other = 0; other < m; ++other) EXPECT_NE(family_pen(0, m).dash, family_pen(0, other).dash);
  }
}

TEST(FamilyLegend, NamesMaterialsOnlyWhereThereAreSeveral) {
  EXPECT_EQ(family_legend({0.0, 30.0}, {"one"}).size(), 2U);
  const auto legend = family_legend({0.0, 30.0}, {"one", "two"});
  ASSERT_EQ(legend.size(), 4U);
  EXPECT_EQ(legend[1].label, "incidence 30°");
  EXPECT_EQ(legend[3].label, "two");
  EXPECT_TRUE(legend[2].starts_row);
}

}  // namespace
}  // namespace lrcs
