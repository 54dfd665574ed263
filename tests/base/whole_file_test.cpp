#include "base/whole_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/digest.h"

namespace lrcs {
namespace {

class WholeFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] auto files() const {
    return std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator());
  }
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "whole_file_test";
  std::filesystem::path file_ = folder_ / "result.csv";
};

TEST_F(WholeFiles, AppearWithAllTheirContent) {
  const std::string bytes("a\0b\n", 4);
  write_whole_file(file_, bytes);
  EXPECT_EQ(content_of_file(file_), bytes);
  write_whole_file(file_, "new");
  EXPECT_EQ(content_of_file(file_), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(WholeFiles, LeaveTheOldContentWhereNothingIsCommitted) {
  write_whole_file(file_, "old");
  {
    const WholeFile whole(file_);
    std::ofstream(whole.temporary()) << "half of";
    EXPECT_EQ(content_of_file(file_), "old");
    EXPECT_EQ(files(), 2);
  }
  EXPECT_EQ(content_of_file(file_), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(WholeFiles, KeepTheExtensionUntilTheyHaveTheirName) {
  EXPECT_EQ(WholeFile(file_).temporary().extension(), ".csv");
  EXPECT_EQ(WholeFile(file_).temporary().parent_path(), folder_);
}

TEST_F(WholeFiles, SayWhereTheyCannotBeWritten) {
  EXPECT_THROW(write_whole_file(folder_ / "missing" / "result.csv", "x"), std::runtime_error);
}

}  // namespace
}  // namespace lrcs
