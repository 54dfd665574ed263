// lrcs_import_bench: how long it takes from a file to a target that is ready. See about() or --help.
#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/bumpy_sphere.h"
#include "bench/machine_facts.h"
#include "bench/median.h"
#include "bench/stopwatch.h"
#include "bench/written_mesh.h"
#include "lrcs/facet_tree.h"
#include "lrcs/occluders.h"
#include "lrcs/scene.h"
#include "lrcs/scene_target.h"
#include "lrcs/visibility.h"
#include "mesh/diagnosis.h"
#include "mesh/read_mesh.h"
#include "tests/scratch_folder.h"

namespace lrcs {
namespace {

constexpr int done = 0, too_slow = 1, could_not_finish = 1, wrong_input = 2;

constexpr auto about =
    "Time from a file of 870,488 facets, a bumpy sphere, to a target that is ready, beside VTK's reader of the "
    "format,\n"
    "in one process; the two take turns, medians of runs.\n"
    "\n"
    "VTK: vtkSTLReader, vtkPLYReader as they are: reads, merges vertices (STL).\n"
    "lrcs, ready: reading; repair with its counts (vertices welded, degenerate and duplicate facets, closed shells\n"
    "turned outward) and all else that makes a target of a scene (digest, body frame, materials); the facets in space\n"
    "order with their tree. Apart: the whole surface of an exact sweep, that tree, edges, contacts, solids and hull\n"
    "among it; and the diagnosis of lrcs info, self-intersections among it.\n"
    "Exit status: 0; 1: --short and ready takes more than 4 times VTK's reader on a binary file; 2: wrong input.";

constexpr double most_over_vtk = 4.0;

template <class Reader>
std::size_t facets_read_by(const std::filesystem::path& file) {
  const vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return static_cast<std::size_t>(reader->GetOutput()->GetNumberOfPolys());
}

std::size_t facets_vtk_reads(const std::filesystem::path& file) {
  return file.extension() == ".stl" ? facets_read_by<vtkSTLReader>(file) : facets_read_by<vtkPLYReader>(file);
}

Scene scene_of(const std::filesystem::path& file) {
  Scene scene;
  scene.target.file = file;
  scene.target.unit = "m";
  scene.materials = {Material{"black", {}, 0.0, ""}};
  scene.assign = {AssignRule{AssignRule::By::everything, "", "black", {}}};
  return scene;
}

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

// [s], medians.
struct ImportTimes {
  double vtk, ready, reading, tree, surface, diagnosis;
};

ImportTimes measure(const std::filesystem::path& file, std::size_t facets, int runs) {
  std::vector<double> vtk, ready, reading, tree, surface, diagnosis;
  for (int run = 0; run < runs; ++run) {
    vtk.push_back(seconds_of([&] { require(facets_vtk_reads(file) == facets, "VTK has not read all facets"); }));
    LoadedTarget loaded;
    const double loading = seconds_of([&] { loaded = load_target(scene_of(file)); });
    require(loaded.target.mesh.size() == facets, "lrcs has not read all facets");
    tree.push_back(seconds_of([&] {
      const Occluders occluders(loaded.target.mesh);
      const FacetTree facet_tree(occluders);
    }));
    ready.push_back(loading + tree.back());
    surface.push_back(seconds_of([&] { const Visibility visibility(loaded.target.mesh); }));
    FacetMesh mesh;
    reading.push_back(seconds_of([&] { mesh = read_mesh(file); }));
    diagnosis.push_back(seconds_of([&] { require(diagnose(mesh).closed, "the sphere has come open"); }));
  }
  return {median(vtk), median(ready), median(reading), median(tree), median(surface), median(diagnosis)};
}

// The largest ratio to VTK among the binary formats.
double compare(std::uint32_t rings, int runs) {
  const ScratchFolder folder;
  const FacetMesh mesh = bumpy_sphere(rings);
  fmt::print("{} facets, {} runs; ms\n{:12}{:>10}{:>10}{:>8}{:>10}{:>10}{:>8}{:>10}{:>11}\n", mesh.size(), runs, "",
             "VTK reads", "ready", "ratio", "reading", "repair", "tree", "surface", "diagnosis");
  double most = 0.0;
  for (const WrittenFormat& format : written_formats()) {
    const auto file = folder.path() / (std::string("target") + format.extension);
    format.write(file, mesh);
    const ImportTimes t = measure(file, mesh.size(), runs);
    fmt::print("{:12}{:10.0f}{:10.0f}{:8.2f}{:10.0f}{:10.0f}{:8.0f}{:10.0f}{:11.0f}\n", format.name, 1e3 * t.vtk,
               1e3 * t.ready, t.ready / t.vtk, 1e3 * t.reading, 1e3 * (t.ready - t.reading - t.tree), 1e3 * t.tree,
               1e3 * t.surface, 1e3 * t.diagnosis);
    std::fflush(stdout);
    if (std::string_view(format.name).ends_with("binary")) most = std::max(most, t.ready / t.vtk);
  }
  return most;
}

int run(int argc, char** argv) {
  bool is_short = false;
  int runs = 5;
  CLI::App app(about, "lrcs_import_bench");
  auto* const only_few = app.add_flag("--short", is_short, "Seconds: one run; fails where the bar is missed");
  app.add_option("--runs", runs, "Runs of each (default 5)")->check(CLI::Range(1, 100))->excludes(only_few);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? done : wrong_input;
  }
  fmt::print("{}", machine_facts());
  constexpr std::uint32_t rings = 467;
  const double most = compare(rings, is_short ? 1 : runs);
  fmt::print("bar {}: ready in at most {} times VTK's reader, binary files: {:.2f}\n",
             most <= most_over_vtk ? "passed" : "missed", most_over_vtk, most);
  return is_short && most > most_over_vtk ? too_slow : done;
}

}  // namespace
}  // namespace lrcs

int main(int argc, char** argv) try { return lrcs::run(argc, argv); } catch (const std::exception& failed) {
  std::fprintf(stderr, "lrcs_import_bench: %s\n", failed.what());
  return lrcs::could_not_finish;
}
