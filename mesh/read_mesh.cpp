#include "mesh/read_mesh.h"

#include <string>

#include "base/input_error.h"
#include "mesh/file_content.h"
#include "mesh/file_format.h"
#include "mesh/read_formats.h"

namespace lrcs {
namespace {

FacetMesh read_as(FileFormat format, std::string_view content, const std::string& name,
                  std::vector<std::string>* warnings, FileNormals* normals) {
  switch (format) {
    case FileFormat::stl_text:
      return read_text_stl(content, name);
    case FileFormat::stl_binary:
      return read_binary_stl(content, name);
    case FileFormat::obj:
      return read_obj(content, name, warnings, normals);
    case FileFormat::ply:
      return read_ply(content, name, normals);
    default:
      return read_off(content, name, normals);
  }
}

}  // namespace

FacetMesh read_mesh(const std::filesystem::path& file, std::vector<std::string>* warnings, FileNormals* normals) {
  const std::string content = plain_content(file);
  FacetMesh mesh = read_as(file_format_of(content, file), content, file.string(), warnings, normals);
  if (mesh.size() == 0) throw InputError(Place{file.string()}, "holds no facets, expected at least one");
  return mesh;
}

}  // namespace lrcs
