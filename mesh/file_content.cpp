#include "mesh/file_content.h"

#include "base/digest.h"
#include "base/gunzip.h"
#include "base/input_error.h"

namespace lrcs {
namespace {

void require_regular(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(Place{file.string()}, "cannot be read: " + error.message());
  if (std::filesystem::is_directory(status)) throw InputError(Place{file.string()}, "is a folder, expected a file");
  if (!std::filesystem::is_regular_file(status)) throw InputError(Place{file.string()}, "is no regular file");
}

}  // namespace

std::string plain_content(const std::filesystem::path& file) {
  require_regular(file);
  std::string bytes = content_of_file(file);
  if (is_gzip(bytes)) bytes = gunzip(bytes, file.string());
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.erase(0, 3);
  return bytes;
}

}  // namespace lrcs
