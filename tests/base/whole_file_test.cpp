#include "base/whole_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/digest.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

class WholeFiles : public testing::Test {
 protected:
  [[nodiscard]] auto files() const {
    return std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator());
  }
  ScratchFolder scratch_;
  std::filesystem::path folder_ = scratch_.path();
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

// A writer is killed at many moments: the file is one of the two contents, and nothing else lies in the folder but a
// whole file that has not got its name yet.
TEST_F(WholeFiles, AreWholeWhenTheWriterIsKilled) {
  const std::string old_content(1 << 20, 'o'), new_content(1 << 20, 'n');
  write_whole_file(file_, old_content);
  for (int round = 0; round < 40; ++round) {
    const pid_t writer = fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) {
      for (;;) write_whole_file(file_, round % 2 == 0 ? new_content : old_content);
    }
    usleep(static_cast<useconds_t>(500 + 137 * round));
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::string content = content_of_file(entry.path());
      EXPECT_TRUE(content == old_content || content == new_content) << entry.path();
    }
  }
}

TEST_F(WholeFiles, SayWhereTheyCannotBeWritten) {
  EXPECT_THROW(write_whole_file(folder_ / "missing" / "result.csv", "x"), std::runtime_error);
}

}  // namespace
}  // namespace lrcs
