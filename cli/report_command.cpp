#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/whole_file.h"
#include "cli/commands.h"
#include "cli/past_run.h"
#include "cli/progress_bar.h"
#include "cli/report_payload.h"
#include "report/report_page.h"
#include "view/part_returns.h"

namespace lrcs {
namespace {

// More facets are decimated for display; of so many bytes rows are stored, the others show the nearest of them.
constexpr std::size_t most_facets = 60'000, most_bytes = 12'000'000;
constexpr std::size_t most_part_returns = 3'000'000;  // 60 MB of them
constexpr std::size_t most_parts = 65'535;            // [report/web/PAYLOAD.md]

// Evenly along the sweep, the first and the last among them.
std::vector<std::size_t> stored_rows(std::size_t rows, std::size_t facets) {
  const std::size_t most = std::clamp<std::size_t>(most_bytes / std::max<std::size_t>(1, facets), 2, rows);
  std::vector<std::size_t> stored;
  for (std::size_t k = 0; k < most; ++k) stored.push_back(most == 1 ? 0 : k * (rows - 1) / (most - 1));
  return stored;
}

// The facets' shares add up to the row of sweep.csv, or it is another target's.
void require_same_sigma(const std::filesystem::path& folder, const PastRun& run, std::size_t row,
                        const Estimate& sigma) {
  if (is_as_before(run, row, sigma)) return;
  throw InputError(Place{(folder / "sweep.csv").string()},
                   fmt::format("row {} says {} m^2, its facets return {} m^2; run the sweep again", row,
                               run.rows[row].sigma.value, sigma.value));
}

void report(const std::filesystem::path& folder, const std::filesystem::path& html, const Common& common) {
  const PastRun run = read_past_run(folder);
  const FacetMesh& mesh = run.loaded.target.mesh;
  if (mesh.part.names.size() > most_parts)
    throw std::runtime_error(
        fmt::format("a report holds at most {} parts, found {}", most_parts, mesh.part.names.size()));
  if (mesh.part.names.size() * run.rows.size() > most_part_returns)
    throw std::runtime_error(
        fmt::format("a report holds at most {} returns of parts, parts times rows; found {} times {}",
                    most_part_returns, mesh.part.names.size(), run.rows.size()));
  const std::string run_facts = report_run_facts(run, folder / "manifest.json");
  const ShownTarget shown = shown_target(mesh, most_facets);
  ShownReturns returns(shown, stored_rows(run.rows.size(), shown.size()));
  std::vector<std::vector<double>> part_sigma(run.rows.size());
  const std::vector<Aspect> aspects = aspects_of(run.scene.directions, run.scene.receiver);
  ProgressBar bar(aspects.size(), "directions", !common.quiet);
  (void)run_sweep(run.loaded.target, aspects, common.threads,
                  {[&](std::size_t done) { bar.update(done); }, [](std::size_t) { return true; },
                   [&](std::size_t row, const SweepRow&, const CrossSection& section) {
                     require_same_sigma(folder, run, row, section.sigma);
                     part_sigma[row] = part_returns(mesh, section.facet_sigma);
                     returns.take(row, section.facet_sigma, section.seen_fraction, mesh.areas);
                   }});
  const std::string page =
      report_page(report_json(run, run_facts, part_sigma, shown, returns), report_facets(run, shown, returns));
  write_whole_file(html, page);
  if (common.quiet) return;
  constexpr double mega = 1e6;
  fmt::print(stderr, "lrcs: report of {} rows, {} facets shown, {:.1f} MB: {}\n", run.rows.size(), shown.size(),
             static_cast<double>(page.size()) / mega, html.string());
}

}  // namespace

void add_report_command(CLI::App& app, Common& common) {
  struct Options {
    std::string folder, html;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("report", "One HTML file of a sweep, to be opened in any browser");
  verb->add_option("folder", options->folder, "Folder that lrcs sweep wrote")->required();
  verb->add_option("-o,--output", options->html, "The file (default: report.html in the folder)");
  add_common_flags(*verb, common);
  verb->callback([options, &common] {
    const std::filesystem::path folder = options->folder;
    report(folder, options->html.empty() ? folder / "report.html" : std::filesystem::path(options->html), common);
  });
}

}  // namespace lrcs
