#pragma once
#include <string>
#include <string_view>

namespace lrcs {

[[nodiscard]] inline bool is_gzip(std::string_view content) {
  return content.starts_with("\x1f\x8b");
}

// The content of a gzip file, of all its members one after the other.
// error: InputError that names the file: damaged, cut off, or so much that no mesh or table packs so well (more
// than 64 MB and more than a hundred times the packed size: memory is not taken for it).
[[nodiscard]] std::string gunzip(std::string_view packed, const std::string& file);

}  // namespace lrcs
