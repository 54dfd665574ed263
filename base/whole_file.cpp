#include "base/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace lrcs {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
}

}  // namespace

WholeFile::WholeFile(std::filesystem::path final_name) : final_(std::move(final_name)) {
  temporary_ = final_.parent_path() /
               fmt::format(".{}.{}.part{}", final_.stem().string(), getpid(), final_.extension().string());
}

WholeFile::~WholeFile() {
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void WholeFile::commit() {
  const int descriptor = open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(temporary_);
  const int synced = fsync(descriptor);
  close(descriptor);
  if (synced != 0 || std::rename(temporary_.c_str(), final_.c_str()) != 0) fail(final_);
}

void write_whole_file(const std::filesystem::path& file, std::string_view content) {
  WholeFile whole(file);
  std::ofstream out(whole.temporary(), std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) fail(file);
  whole.commit();
}

}  // namespace lrcs
