#include "base/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

namespace lrcs {
namespace {

// An open file that is closed, and its temporary name taken away, whatever happens.
struct OpenFile {
  int descriptor = -1;
  std::string name;  // "" while it has none

  OpenFile() = default;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor >= 0) close(descriptor);
    if (!name.empty()) unlink(name.c_str());
  }
};

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
}

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
  return fsync(descriptor) == 0;
}

constexpr mode_t mode = 0666;  // less what the umask takes away

bool write_nameless(OpenFile& file, const std::string& folder, const std::string& name, std::string_view content) {
  file.descriptor = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
  if (file.descriptor < 0 || !write_all(file.descriptor, content)) return false;
  const std::string link = fmt::format("/proc/self/fd/{}", file.descriptor);
  if (linkat(AT_FDCWD, link.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0) return false;
  file.name = name;
  return true;
}

bool write_named(OpenFile& file, const std::string& name, std::string_view content) {
  file.descriptor = open(name.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, mode);
  if (file.descriptor < 0) return false;
  file.name = name;
  return write_all(file.descriptor, content);
}

}  // namespace

void write_whole_file(const std::filesystem::path& file, std::string_view content) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const std::string name = folder / fmt::format(".{}.{}.part", file.filename().string(), getpid());
  unlink(name.c_str());
  OpenFile nameless, named;
  const bool written = write_nameless(nameless, folder, name, content) || write_named(named, name, content);
  if (!written || std::rename(name.c_str(), file.c_str()) != 0) fail(file);
}

}  // namespace lrcs
