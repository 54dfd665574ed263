#include "cad/read_target.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/length.h"
#include "cad/contained.h"
#include "cad/mesh_bytes.h"
#include "cad/occt_module.h"
#include "mesh/file_format.h"
#include "mesh/read_mesh.h"

namespace lrcs {
namespace {

constexpr Tessellation usual;

// A hundred times what good files take here: reading grows with the file, tessellation with its fineness too.
ReaderLimits limits_for(const std::filesystem::path& file, const Tessellation& wanted) {
  const double megabytes = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
  const double chord = wanted.absolute ? 10.0 : usual.relative / wanted.relative;
  const double fineness = std::max({1.0, chord, usual.angle_deg / wanted.angle_deg});
  ReaderLimits limits;
  limits.processor_s = (4.0 + 60.0 * megabytes) * fineness;
  return limits;
}

std::string said(const Tessellation& wanted) {
  const std::string chord = wanted.absolute ? text_of_length(*wanted.absolute, "mm")
                                            : fmt::format("{} of the diagonal of each part's box", wanted.relative);
  return fmt::format("chord tolerance {}, at most {} deg from edge to edge", chord, wanted.angle_deg);
}

TargetRead read_contained(const std::filesystem::path& file, FileFormat format, const std::string& unit,
                          const Tessellation& wanted) {
  const std::string bytes = contained(file.string(), limits_for(file, wanted), [&] {
    std::string result;
    load_occt_module()({file.string(), format, unit, wanted}, result);
    return result;
  });
  std::string_view rest = bytes;
  TargetRead target;
  target.mesh = mesh_of_bytes(rest);
  target.unit = take_words(rest).at(0);
  target.warnings = take_words(rest);
  target.tessellation = said(wanted);
  return target;
}

}  // namespace

TargetRead read_target(const std::filesystem::path& file, const std::string& unit, const Tessellation& tessellation) {
  if (const auto format = cad_format_of(file)) return read_contained(file, *format, unit, tessellation);
  TargetRead target;
  target.mesh = read_mesh(file);
  target.unit = unit;
  if (!unit.empty()) target.mesh.metres_per_unit = metres_in(unit);
  return target;
}

}  // namespace lrcs
