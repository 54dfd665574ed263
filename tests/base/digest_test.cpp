#include "base/digest.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/input_error.h"

namespace lrcs {
namespace {

TEST(Digest, IsTheSha256OfThePublishedExamples) {
  EXPECT_EQ(digest_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Digest, OfAFileIsThatOfItsBytes) {
  const auto file = std::filesystem::path(testing::TempDir()) / "digest_test.bin";
  const std::string bytes("a\0b\r\n\xff", 6);
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  EXPECT_EQ(content_of_file(file), bytes);
  EXPECT_EQ(digest_of_file(file), digest_of(bytes));
  std::filesystem::remove(file);
}

TEST(Digest, NamesAFileThatCannotBeRead) {
  EXPECT_THROW(static_cast<void>(digest_of_file("/no/such/file")), InputError);
  EXPECT_THROW(static_cast<void>(content_of_file("/")), InputError);
}

}  // namespace
}  // namespace lrcs
