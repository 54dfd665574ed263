#include "base/gunzip.h"

#include <gtest/gtest.h>

#include <random>

#include "base/input_error.h"
#include "tests/base/gzip.h"

namespace lrcs {
namespace {

std::string complaint_about(const std::string& packed) {
  try {
    (void)gunzip(packed, "a.stl.gz");
    return "none";
  } catch (const InputError& wrong) {
    return wrong.what();
  }
}

TEST(Gunzip, IsTheInverseOfGzip) {
  std::string random(5'000'000, '\0');
  std::mt19937 engine(3);
  for (char& c : random) c = static_cast<char>(engine());
  for (const std::string& content : {std::string(), std::string("x"), std::string(20'000'000, 'y'), random})
    EXPECT_TRUE(gunzip(gzip(content), "a") == content) << content.size();
}

TEST(Gunzip, TakesAllMembers) {
  EXPECT_EQ(gunzip(gzip("ab") + gzip("c"), "a"), "abc");
}

TEST(Gunzip, RefusesWhatIsDamaged) {
  const std::string good = gzip(std::string(1000, 'y') + "z");
  EXPECT_EQ(complaint_about(good.substr(0, good.size() - 5)),
            "a.stl.gz: is compressed by gzip and cannot be unpacked: cut off");
  EXPECT_EQ(complaint_about(good + "more"),
            "a.stl.gz: is compressed by gzip and cannot be unpacked: incorrect header check");
  std::string wrong = good;
  wrong[wrong.size() - 6] ^= 1;
  EXPECT_EQ(complaint_about(wrong), "a.stl.gz: is compressed by gzip and cannot be unpacked: incorrect data check");
}

TEST(Gunzip, DoesNotTakeMemoryForABomb) {
  EXPECT_EQ(
      complaint_about(gzip(std::string(200'000'000, '\0'))),
      "a.stl.gz: is compressed by gzip and cannot be unpacked: unpacks to more than 64 MB, expected at most that");
}

}  // namespace
}  // namespace lrcs
