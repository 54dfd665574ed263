#include "cli/part_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/compensated_sum.h"
#include "view/part_returns.h"

namespace lrcs {
namespace {

constexpr std::size_t most_parts = 7;

// Of each row of the cut, with what its parts return.
struct PartRow {
  Estimate sigma;
  std::vector<double> part_sigma;
};

std::vector<PartRow> part_rows(const PastRun& run, const ViewedCut& cut, std::size_t threads,
                               const std::function<void(std::size_t done)>& progress) {
  std::vector<Aspect> aspects;
  for (const std::size_t row : cut.rows) aspects.push_back(run.rows[row].aspect);
  std::vector<PartRow> parts(aspects.size());
  (void)run_sweep(run.loaded.target, aspects, threads,
                  {progress, [](std::size_t) { return true; },
                   [&](std::size_t row, const SweepRow& result, const CrossSection& section) {
                     parts[row] = {result.sigma, part_returns(run.loaded.target.mesh, section.facet_sigma)};
                   }});
  return parts;
}

void require_same_sigma(const PastRun& run, const ViewedCut& cut, const std::vector<PartRow>& parts,
                        const std::vector<double>& top) {
  constexpr double rounding = 1e-12;  // of sigma
  for (std::size_t i = 0; i < top.size(); ++i) {
    const Estimate& now = parts[i].sigma;
    const bool is_sum = std::abs(top[i] - now.value) <= rounding * now.value;
    if (!is_sum || !is_as_before(run, cut.rows[i], now))
      throw std::runtime_error(fmt::format("row {}: the parts return {} m^2 together, sweep.csv says {} m^2",
                                           cut.rows[i], top[i], run.rows[cut.rows[i]].sigma.value));
  }
}

}  // namespace

LayerStack part_stack(const PastRun& run, const ViewedCut& cut, std::size_t threads,
                      const std::function<void(std::size_t done)>& progress) {
  const std::vector<PartRow> rows = part_rows(run, cut, threads, progress);
  const auto& names = run.loaded.target.mesh.part.names;
  std::vector<double> over_cut(names.size(), 0.0);
  for (const PartRow& row : rows)
    for (std::size_t part = 0; part < names.size(); ++part) over_cut[part] += row.part_sigma[part];
  LayerStack stack{cut.curve.angle_deg, {}, {}};
  std::vector<bool> shown(names.size(), false);
  for (const std::uint32_t part : strongest_parts(over_cut, most_parts)) {
    shown[part] = true;
    stack.layers.push_back({names[part], {}});
    for (const PartRow& row : rows) stack.layers.back().sigma_m2.push_back(row.part_sigma[part]);
  }
  const bool has_others = strongest_parts(over_cut, names.size()).size() > stack.layers.size();
  for (const PartRow& row : rows) {
    CompensatedSum others;
    for (std::size_t part = 0; part < names.size(); ++part)
      if (!shown[part]) others.add(row.part_sigma[part]);
    if (has_others) stack.others_m2.push_back(others.value());
  }
  require_same_sigma(run, cut, rows, stack_top(stack));
  return stack;
}

}  // namespace lrcs
