// Run time against error: the exact way beside rays. One process, one thread.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/input_error.h"
#include "base/whole_file.h"
#include "bench/bumpy_sphere.h"
#include "bench/median.h"
#include "bench/work_precision.h"
#include "mesh/read_mesh.h"

namespace {

using lrcs::bench::Measurement;
using lrcs::bench::median;

// Medians over the directions of each method, in the order in which they ran.
struct Row {
  std::string method;
  double seconds, ratio, error_lambert, error_metal_skin, error_seen_area;  // ratio: to one ray a facet
};

std::vector<Row> medians(const std::vector<Measurement>& of_target) {
  std::vector<std::string> names;
  std::map<std::string, std::vector<Measurement>> by_method;
  for (const Measurement& m : of_target) {
    if (by_method[m.method].empty()) names.push_back(m.method);
    by_method[m.method].push_back(m);
  }
  const auto& one_ray = by_method.at(lrcs::bench::one_ray_a_facet);
  std::vector<Row> rows;
  for (const std::string& name : names) {
    const auto& all = by_method.at(name);
    const auto middle = [&](auto&& value) {
      std::vector<double> values;
      for (std::size_t k = 0; k < all.size(); ++k) values.push_back(value(k));
      return median(values);
    };
    rows.push_back({name, middle([&](std::size_t k) { return all[k].seconds; }),
                    middle([&](std::size_t k) { return all[k].seconds / one_ray[k].seconds; }),
                    middle([&](std::size_t k) { return all[k].error_lambert; }),
                    middle([&](std::size_t k) { return all[k].error_metal_skin; }),
                    middle([&](std::size_t k) { return all[k].error_seen_area; })});
  }
  return rows;
}

void print(const std::vector<Measurement>& of_target) {
  fmt::print("\n{}, {} facets\n{:24}{:>12}{:>12}{:>14}{:>14}{:>14}\n", of_target.front().target,
             of_target.front().facets, "method", "time [ms]", "/ one ray", "error Lambert", "metal skin", "seen area");
  for (const Row& r : medians(of_target))
    fmt::print("{:24}{:12.2f}{:12.2f}{:14.1e}{:14.1e}{:14.1e}\n", r.method, 1e3 * r.seconds, r.ratio, r.error_lambert,
               r.error_metal_skin, r.error_seen_area);
  std::fflush(stdout);
}

void write_csv(const std::filesystem::path& file, const std::vector<Measurement>& measured) {
  std::string text =
      "target,facets,azimuth_deg,elevation_deg,method,seconds,error_lambert,error_metal_skin,error_seen_area\n";
  for (const Measurement& m : measured)
    text += fmt::format("{},{},{:.6f},{:.6f},{},{:.6e},{:.3e},{:.3e},{:.3e}\n", m.target, m.facets, m.azimuth_deg,
                        m.elevation_deg, m.method, m.seconds, m.error_lambert, m.error_metal_skin, m.error_seen_area);
  lrcs::write_whole_file(file, text);
}

// Time grows as facets^exponent, fitted over the bumpy spheres.
void print_growth(const std::vector<Measurement>& spheres) {
  std::map<std::string, std::map<std::size_t, std::vector<double>>> times;
  for (const Measurement& m : spheres) times[m.method][m.facets].push_back(m.seconds);
  fmt::print("\ngrowth of time over the bumpy spheres: facets^exponent\n");
  for (const auto& [method, by_facets] : times) {
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (const auto& [facets, seconds] : by_facets) {
      const double x = std::log(static_cast<double>(facets)), y = std::log(median(seconds));
      n += 1.0;
      sx += x;
      sy += y;
      sxx += x * x;
      sxy += x * y;
    }
    if (n > 1.0) fmt::print("{:24}{:12.2f}\n", method, (n * sxy - sx * sy) / (n * sxx - sx * sx));
  }
}

// A ray grid that is farther from the exact answer than sampling can be: one of the two is wrong.
bool agree(const std::vector<Measurement>& measured) {
  constexpr double most = 0.05;  // relative; ten times what the coarsest grid was seen to make
  bool good = true;
  for (const Measurement& m : measured)
    if (m.method.starts_with("ray grid") && !(m.error_seen_area <= most)) {
      fmt::print(stderr, "{} at ({:.1f}, {:.1f}): {} is off by {:.1e}\n", m.target, m.azimuth_deg, m.elevation_deg,
                 m.method, m.error_seen_area);
      good = false;
    }
  return good;
}

int run(int argc, char** argv) {
  CLI::App app("Run time against error of seen fractions: exact, rays from facets, rays through pixels");
  std::vector<std::string> targets;
  std::filesystem::path out;
  unsigned directions = 5;
  std::size_t most_facets = 2100000;
  bool short_run = false;
  app.add_option("targets", targets, "mesh files; bumpy spheres are always there");
  app.add_option("-o,--output", out, "CSV with every measurement");
  app.add_option("--directions", directions, "seeded directions a target")->check(CLI::Range(1, 1000));
  app.add_option("--most-facets", most_facets, "of the bumpy spheres")->check(CLI::Range(1000, 10000000));
  app.add_flag("--short", short_run, "a check that all works: small spheres, few methods");
  CLI11_PARSE(app, argc, argv);
  if (short_run) most_facets = std::min<std::size_t>(most_facets, 130000);

  std::vector<Measurement> measured, spheres;
  const auto take = [&](const std::string& name, const lrcs::FacetMesh& mesh) {
    auto of_target = lrcs::bench::measure(name, mesh, directions, short_run);
    print(of_target);
    measured.insert(measured.end(), of_target.begin(), of_target.end());
    return of_target;
  };
  for (const std::string& file : targets) {
    lrcs::FacetMesh mesh = lrcs::read_mesh(file);
    measure_facets(mesh);
    take(std::filesystem::path(file).filename().string(), mesh);
  }
  for (const unsigned rings : {90U, 180U, 360U, 708U}) {
    const auto facets = std::size_t{4} * rings * (rings - 1);
    if (facets > most_facets) continue;
    const auto of_sphere = take(fmt::format("bumpy sphere {}k", facets / 1000), lrcs::bench::bumpy_sphere(rings));
    spheres.insert(spheres.end(), of_sphere.begin(), of_sphere.end());
  }
  if (!spheres.empty()) print_growth(spheres);
  if (!out.empty()) write_csv(out, measured);
  return agree(measured) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const lrcs::InputError& error) {
    fmt::print(stderr, "lrcs_bench: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "lrcs_bench: {}\n", error.what());
    return 1;
  }
}
