#include "cad/read_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/input_error.h"
#include "base/length.h"
#include "cad/contained.h"
#include "cad/imported_mesh.h"
#include "cad/reader_module.h"
#include "mesh/file_format.h"
#include "mesh/file_normals.h"
#include "mesh/read_mesh.h"

namespace lrcs {
namespace {

constexpr Tessellation usual;

// A hundred times what good files take here: reading grows with the file, tessellation with its fineness too.
ReaderLimits limits_for(const std::filesystem::path& file, FileFormat format, const Tessellation& wanted) {
  const double megabytes = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
  const double chord = wanted.absolute ? 10.0 : usual.relative / wanted.relative;
  const double fineness = std::max({1.0, chord, usual.angle_deg / wanted.angle_deg});
  ReaderLimits limits;
  // CAD files hang readers, and hold all there is in one file; of others the bulk may be elsewhere, or packed.
  const double least = holds_surfaces(format) ? 4.0 : 60.0;
  limits.processor_s = (least + 60.0 * megabytes) * fineness;
  return limits;
}

std::string said(const Tessellation& wanted) {
  const std::string chord = wanted.absolute ? text_of_length(*wanted.absolute, "mm")
                                            : fmt::format("{} of the diagonal of each part's box", wanted.relative);
  return fmt::format("chord tolerance {}, at most {} deg from edge to edge", chord, wanted.angle_deg);
}

const char* reader_of(FileFormat format) {
  if (format == FileFormat::vtk_xml) return "vtk";
  return holds_surfaces(format) ? "occt" : "assimp";
}

TargetRead read_contained(const std::filesystem::path& file, FileFormat format, const std::string& unit,
                          const Tessellation& wanted) {
  const bool surfaces = holds_surfaces(format);
  if (surfaces && wanted.curving.by == Curving::By::file_normals)
    throw InputError(Place{file.string()}, "holds surfaces, not normals at vertices, expected curved: auto");
  const std::string bytes = contained(file.string(), limits_for(file, format, wanted), [&] {
    std::string result;
    load_reader(reader_of(format))({file.string(), format, unit, wanted}, result);
    return result;
  });
  ImportedMesh imported = [&] {
    try {
      return imported_of(bytes);
    } catch (const std::runtime_error& nonsense) {
      throw InputError(Place{file.string()}, fmt::format("its reader gave {}: damaged?", nonsense.what()));
    }
  }();
  return {std::move(imported.mesh), imported.unit, surfaces ? said(wanted) : "", std::move(imported.warnings)};
}

// What lidar looks at is larger than a grain and smaller than a mountain: else the unit may be another.
void doubt_unit(TargetRead& read) {
  constexpr double least = 1e-3, most = 1e3;                // [m]
  constexpr double usual_least = 1e-2, usual_most = 200.0;  // [m]
  const double size = read.mesh.metres_per_unit * diagonal_of(read.mesh);
  if (read.unit.empty() || size == 0.0 || (size >= least && size <= most)) return;
  std::vector<std::string> others;
  for (const char* unit : {"mm", "cm", "inch", "ft", "m"}) {
    const double in_unit = size / read.mesh.metres_per_unit * metres_in(unit);
    if (in_unit >= usual_least && in_unit <= usual_most) others.push_back(fmt::format("{:.3g} m in {}", in_unit, unit));
  }
  read.warnings.push_back(fmt::format("the target is {:.3g} m across in {}: is that its unit?{}", size, read.unit,
                                      others.empty() ? "" : fmt::format(" It would be {}", fmt::join(others, ", "))));
}

TargetRead read_any(const std::filesystem::path& file, const std::string& unit, const Tessellation& tessellation) {
  if (const auto format = foreign_format_of(file)) return read_contained(file, *format, unit, tessellation);
  TargetRead target;
  const bool by_normals = tessellation.curving.by == Curving::By::file_normals;
  FileNormals normals;
  target.mesh = read_mesh(file, &target.warnings, by_normals ? &normals : nullptr);
  if (by_normals) normals.curve(target.mesh, file.string(), target.warnings);
  target.unit = unit;
  if (!unit.empty()) target.mesh.metres_per_unit = metres_in(unit);
  return target;
}

}  // namespace

TargetRead read_target(const std::filesystem::path& file, const std::string& unit, const Tessellation& tessellation) {
  TargetRead read = read_any(file, unit, tessellation);
  doubt_unit(read);
  return read;
}

}  // namespace lrcs
