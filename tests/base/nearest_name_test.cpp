#include "base/nearest_name.h"

#include <gtest/gtest.h>

namespace lrcs {
namespace {

const std::vector<std::string> keys{"wavelength", "target", "materials", "assign", "sweep", "kb", "kr"};

TEST(NearestName, IsTheWordASlipOfThePenAway) {
  EXPECT_EQ(nearest_name("wavelenght", keys), "wavelength");  // neighbours swapped
  EXPECT_EQ(nearest_name("targt", keys), "target");           // left out
  EXPECT_EQ(nearest_name("swweep", keys), "sweep");           // put in
  EXPECT_EQ(nearest_name("asaign", keys), "assign");          // changed
  EXPECT_EQ(nearest_name("sweep", keys), "sweep");
}

TEST(NearestName, IsTheWordThatBeginsSo) {
  EXPECT_EQ(nearest_name("wave", keys), "wavelength");
  EXPECT_EQ(nearest_name("mat", keys), "materials");
  EXPECT_EQ(nearest_name("ma", keys), "");
}

TEST(NearestName, IsNoneForAWordThatIsFarFromAll) {
  EXPECT_EQ(nearest_name("colour", keys), "");
  EXPECT_EQ(nearest_name("x", keys), "");
  EXPECT_EQ(nearest_name("", keys), "");
  EXPECT_EQ(nearest_name("sweep", {}), "");
}

TEST(NearestName, PrefersTheFirstOfEquals) {
  EXPECT_EQ(nearest_name("kx", keys), "kb");
}

TEST(NearestName, MakesASentenceOrNothing) {
  EXPECT_EQ(did_you_mean("targt", keys), ", did you mean 'target'?");
  EXPECT_EQ(did_you_mean("colour", keys), "");
}

}  // namespace
}  // namespace lrcs
