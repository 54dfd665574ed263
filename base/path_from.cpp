#include "base/path_from.h"

namespace lrcs {

std::string path_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code no_folder, no_file;
  const auto from = std::filesystem::canonical(folder, no_folder), to = std::filesystem::canonical(file, no_file);
  return (no_folder || no_file ? std::filesystem::absolute(file) : to.lexically_relative(from)).string();
}

}  // namespace lrcs
