#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <memory>
#include <stdexcept>

#include "base/input_error.h"
#include "base/length.h"
#include "cad/read_target.h"
#include "cli/commands.h"
#include "cli/flag_words.h"
#include "cli/tessellation_flags.h"
#include "mesh/diagnosis.h"
#include "mesh/gaps.h"
#include "mesh/info_text.h"
#include "mesh/thorough_repair.h"
#include "mesh/write_mesh.h"
#include "view/facets_vtp.h"

namespace lrcs {
namespace {

constexpr std::size_t usual_hole_edges = 1000;

struct RepairOptions {
  std::string target, tolerance, output;
  TessellationFlags file;
  bool drop_opposite = false;
  std::size_t most_hole_edges = 0;
};

// [positions' unit]
double tolerance_of(const RepairOptions& options, const TargetRead& read) {
  const Place place{"--tolerance"};
  if (options.tolerance.empty()) return usual_gap(read.mesh);
  double number = 0.0;
  const char* const end = options.tolerance.data() + options.tolerance.size();
  if (const auto [at, wrong] = std::from_chars(options.tolerance.data(), end, number);
      wrong == std::errc{} && at == end) {
    if (!(number >= 0.0 && number <= 0.1))
      throw InputError(place,
                       fmt::format("expected 0..0.1 of the diagonal of the target's box, found {}", options.tolerance));
    return number * diagonal_of(read.mesh);
  }
  if (read.unit.empty())
    throw InputError(place,
                     "expected a fraction of the target's size, or a length and --unit, which the file does not say");
  try {
    return length_from_text(options.tolerance) / read.mesh.metres_per_unit;
  } catch (const std::invalid_argument& wrong) {
    throw InputError(place, wrong.what());
  }
}

bool is_vtp(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".vtp" || extension == ".VTP";
}

void require_writable(const std::filesystem::path& file) {
  if (!is_vtp(file) && !writes_mesh(file))
    throw InputError(Place{file.string()},
                     fmt::format("expected a name that ends in one of {}, .vtp", fmt::join(mesh_extensions(), ", ")));
  require_folder_of(file, "--output");
}

// What was done to the whole.
void say_counts(const ThoroughCounts& c) {
  fmt::print("welded                {} equal vertices, {} near ones\n", c.welded_vertices, c.near_vertices);
  fmt::print("dropped               {} degenerate, {} duplicate, {} opposite facets\n", c.degenerate, c.duplicate,
             c.opposite);
  fmt::print("split                 {} T-junctions\n", c.t_junctions);
  fmt::print("turned over           {} facets, {} shells that faced inward among them\n", c.flipped, c.inward_shells);
  fmt::print("filled                {} holes\n", c.holes_filled);
}

// The parts to which anything was done.
void say_parts(const ThoroughRepairs& repairs, const std::vector<std::string>& names) {
  if (names.size() < 2) return;
  for (std::size_t p = 0; p < names.size(); ++p) {
    const ThoroughCounts& c = repairs.parts[p];
    if (c.degenerate + c.duplicate + c.opposite + c.flipped == 0) continue;
    fmt::print("  {}: dropped {} degenerate, {} duplicate, {} opposite; turned over {}\n", shown_name(names[p]),
               c.degenerate, c.duplicate, c.opposite, c.flipped);
  }
}

// What is wrong still.
void say_left(const Diagnosis& left) {
  fmt::print(
      "left                  {}, {} boundary edges round {} holes or sheets, {} non-manifold edges, {}{} pairs of "
      "facets that intersect\n",
      left.closed ? "closed" : "open", left.boundary_edges, left.holes, left.non_manifold_edges,
      left.self_intersections.complete ? "" : "at least ", left.self_intersections.pairs);
}

// What the format of the written file cannot hold.
void say_losses(const FacetMesh& mesh, const std::filesystem::path& file) {
  const bool names = mesh.part.names.size() > 1 || mesh.file_material.names.size() > 1;
  const bool more = !mesh.colour.of.empty() || !mesh.layer.of.empty() || !mesh.properties.empty();
  if (is_vtp(file) || !(names || more)) return;
  const bool obj = file.extension() == ".obj" || file.extension() == ".OBJ";
  if (!obj || more)
    fmt::print(stderr, "lrcs: warning: {} holds no {}: .vtp does\n", file.string(),
               obj ? "colours, layers and facet properties" : "parts, materials, colours and facet properties");
}

std::string unit_text(const TargetRead& read) {
  return read.unit.empty() ? "in the file's unit" : "in " + read.unit;
}

void run(const RepairOptions& options, bool quiet) {
  require_writable(options.output);
  Tessellation tessellation = options.file.tessellation();
  tessellation.curving.by = Curving::By::nothing;
  TargetRead read = read_target(options.target, options.file.unit, tessellation);
  const double tolerance = tolerance_of(options, read);
  const ThoroughRepairs repairs =
      repair_thoroughly(read.mesh, {tolerance, options.drop_opposite, options.most_hole_edges});
  if (is_vtp(options.output))
    write_mesh_vtp(options.output, read.mesh);
  else
    write_mesh(options.output, read.mesh);
  if (quiet) return;
  for (const auto& warning : read.warnings) fmt::print(stderr, "lrcs: warning: {}\n", warning);
  if (!repairs.all.complete) fmt::print(stderr, "lrcs: warning: too many gaps: some are left, run it again\n");
  say_losses(read.mesh, options.output);
  fmt::print("{}: {} facets, {} vertices, {}\n", options.output, read.mesh.size(), read.mesh.positions.size(),
             unit_text(read));
  fmt::print("gaps closed up to     {:.3g} {}\n", tolerance * read.mesh.metres_per_unit,
             read.unit.empty() ? "unit" : "m");
  say_counts(repairs.all);
  say_parts(repairs, read.mesh.part.names);
  say_left(diagnose(read.mesh));
}

}  // namespace

void add_repair_command(CLI::App& app, Common& common) {
  const auto options = std::make_shared<RepairOptions>();
  CLI::App* verb = app.add_subcommand("repair", "Mend a target's facets, and write them to a file");
  verb->add_option("target", options->target, "A file that info reads")->required();
  verb->add_option("-o,--output", options->output, "OBJ, PLY, OFF, STL or VTP file to write, in the target's unit")
      ->required();
  options->file.add_to(*verb);
  verb->add_option("--tolerance", options->tolerance,
                   "Gaps to close: of the diagonal of the target's box (default 1e-6), or a length; 0: none");
  verb->add_flag("--drop-opposite", options->drop_opposite,
                 "Of two facets with the same vertices that face opposite ways, drop the later");
  verb->add_option("--fill-holes", options->most_hole_edges,
                   fmt::format("Fill holes of at most so many edges (default {}); sheets get a back", usual_hole_edges))
      ->expected(0, 1)
      ->default_str(std::to_string(usual_hole_edges));
  add_common_flags(*verb, common);
  verb->callback([options, &common] { run(*options, common.quiet); });
}

}  // namespace lrcs
