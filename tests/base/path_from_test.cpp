#include "base/path_from.h"

#include <gtest/gtest.h>

#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

TEST(PathFrom, LeadsBackToTheFile) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "a" / "b");
  folder.write("x.stl", "");
  folder.write("a/y.stl", "");
  EXPECT_EQ(path_from(folder.path() / "a" / "b", folder.path() / "x.stl"), "../../x.stl");
  EXPECT_EQ(path_from(folder.path() / "a", folder.path() / "a" / "y.stl"), "y.stl");
  EXPECT_EQ(path_from(folder.path() / "a", folder.path() / "a" / "b" / ".." / ".." / "x.stl"), "../x.stl");
}

TEST(PathFrom, FollowsLinks) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "real" / "deep");
  folder.write("real/x.stl", "");
  std::filesystem::create_directory_symlink(folder.path() / "real" / "deep", folder.path() / "link");
  EXPECT_EQ(path_from(folder.path() / "link", folder.path() / "real" / "x.stl"), "../x.stl");
}

TEST(PathFrom, IsAbsoluteWhereAFileIsMissing) {
  const ScratchFolder folder;
  EXPECT_EQ(path_from(folder.path(), folder.path() / "none.stl"), (folder.path() / "none.stl").string());
}

}  // namespace
}  // namespace lrcs
