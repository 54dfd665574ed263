#include "base/length.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace lrcs {
namespace {

std::string complaint(const std::string& text) {
  try {
    return "accepted as " + std::to_string(length_from_text(text));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(Length, IsReadToTheNearestDouble) {
  EXPECT_EQ(length_from_text("1.06 um"), 1.06e-6);
  EXPECT_EQ(length_from_text("1064nm"), 1.064e-6);
  EXPECT_EQ(length_from_text("  +0.3e1 mm "), 3e-3);
  EXPECT_EQ(length_from_text("1.55 \u00b5m"), 1.55e-6);
  EXPECT_EQ(length_from_text("1.55 \u03bcm"), 1.55e-6);
  EXPECT_EQ(length_from_text("12 m"), 12.0);
  EXPECT_EQ(length_from_text("2 inch"), 0.0508);
  EXPECT_EQ(length_from_text("2 in"), 0.0508);
}

TEST(Length, OfADecimalUnitIsTheSameNumberInEveryUnit) {
  std::mt19937 engine(41);
  std::uniform_int_distribution<int> digits(1, 99999999);
  for (int k = 0; k < 2000; ++k) {
    const std::string number = std::to_string(digits(engine));
    const double metres = std::stod(number + "e-6");
    EXPECT_EQ(length_from_text(number + " um"), metres);
    EXPECT_EQ(length_from_text(number + "e3 nm"), metres);
    EXPECT_EQ(length_from_text(number + "e-9 km"), metres);
  }
}

TEST(Length, KnowsEveryListedUnit) {
  for (const std::string& unit : length_units()) {
    EXPECT_GT(metres_in(unit), 0.0);
    EXPECT_DOUBLE_EQ(length_from_text("1 " + unit), metres_in(unit));
  }
  EXPECT_EQ(metres_in("mil"), 2.54e-5);
  EXPECT_EQ(metres_in("ft"), 0.3048);
}

TEST(Length, RefusesWhatIsNoPositiveNumberWithAUnit) {
  for (const char* wrong : {"", " ", "1.06", "um", "-1 um", "0 um", "nan um", "inf m", "1e999 m", "1e-400 m", "--1 m",
                            "+-1 m", "+ m", "1e99999999999 um", "1e305 km km", "1.0.0 m"})
    EXPECT_THROW(static_cast<void>(length_from_text(wrong)), std::invalid_argument) << wrong;
}

TEST(Length, SaysWhatWasExpected) {
  EXPECT_EQ(complaint("1.06"), "expected a positive length with its unit, such as '1.06 um', found '1.06'");
  EXPECT_EQ(complaint("1.06 umm"),
            "unknown length unit 'umm', did you mean 'um'? (known: nm, um, mm, cm, dm, m, km, inch, in, ft, mil)");
  EXPECT_THAT(complaint("1 parsec"), testing::StartsWith("unknown length unit 'parsec' (known: nm"));
  EXPECT_THROW(static_cast<void>(metres_in("")), std::invalid_argument);
}

TEST(Length, ReadsBackWhatItWrites) {
  EXPECT_EQ(text_of_length(1.06e-6, "um"), "1.06 um");
  EXPECT_EQ(text_of_length(1.064e-6, "nm"), "1064 nm");
  std::mt19937 engine(42);
  std::uniform_real_distribution<double> exponent(-12.0, 3.0);
  for (int k = 0; k < 2000; ++k) {
    const double metres = std::pow(10.0, exponent(engine));
    for (const std::string& unit : length_units()) EXPECT_EQ(length_from_text(text_of_length(metres, unit)), metres);
  }
}

}  // namespace
}  // namespace lrcs
