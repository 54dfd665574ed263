#include "mesh/read_mesh.h"

#include <string>

#include "base/digest.h"
#include "base/gunzip.h"
#include "base/input_error.h"
#include "mesh/file_format.h"
#include "mesh/read_formats.h"

namespace lrcs {
namespace {

void require_regular(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(Place{file.string()}, "cannot be read: " + error.message());
  if (std::filesystem::is_directory(status)) throw InputError(Place{file.string()}, "is a folder, expected a file");
  if (!std::filesystem::is_regular_file(status)) throw InputError(Place{file.string()}, "is no regular file");
}

FacetMesh read_as(FileFormat format, std::string_view content, const std::string& name) {
  switch (format) {
    case FileFormat::stl_text:
      return read_text_stl(content, name);
    case FileFormat::stl_binary:
      return read_binary_stl(content, name);
    case FileFormat::obj:
      return read_obj(content, name);
    case FileFormat::ply:
      return read_ply(content, name);
    default:
      return read_off(content, name);
  }
}

}  // namespace

FacetMesh read_mesh(const std::filesystem::path& file) {
  require_regular(file);
  std::string bytes = content_of_file(file);
  if (is_gzip(bytes)) bytes = gunzip(bytes, file.string());
  std::string_view content = bytes;
  if (content.starts_with("\xef\xbb\xbf")) content.remove_prefix(3);  // UTF-8's byte order mark
  FacetMesh mesh = read_as(file_format_of(content, file), content, file.string());
  if (mesh.size() == 0) throw InputError(Place{file.string()}, "holds no facets, expected at least one");
  return mesh;
}

}  // namespace lrcs
