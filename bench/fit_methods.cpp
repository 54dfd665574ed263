#include "bench/fit_methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/ceres_starts.h"
#include "bench/pagmo_methods.h"
#include "fit/brdf_fit.h"
#include "fit/descent.h"
#include "fit/gsaa.h"
#include "fit/search.h"

namespace lrcs {
namespace {

FitOptions options_for(const FitTask& task) {
  FitOptions options;
  options.gsaa.seed = task.data.seed;
  return options;
}

FitEnd lrcs_search(const FitTask& task) {
  const Polished found = search(task.box.problem(), options_for(task));
  return {found.parameters, found.evaluations};
}

FitEnd lrcs_fit(const FitTask& task) {
  const BrdfFit fit = fit_brdf(task.data.measurement, task.form, options_for(task));
  FitEnd end{{}, fit.evaluations};
  for (const FittedParameter& p : fit.parameters) end.parameters.push_back(p.value);
  return end;
}

// It cools to a millionth of its first temperature, whatever the number of generations.
FitEnd plain_gsaa(const FitTask& task, int budget) {
  GsaaOptions options;
  options.seed = task.data.seed;
  options.population = std::min(64, budget / 2);
  options.generations = budget / options.population - 1;
  constexpr double last_temperature = 1e-6;  // over the first
  options.cooling = std::pow(last_temperature, 1.0 / options.generations);
  const auto found =
      gsaa(task.box.dimensions(), options, [&](std::span<const double> place) { return task.box.squares_at(place); });
  return {task.box.values_at_place(found.front().place), options.population * (options.generations + 1L)};
}

}  // namespace

std::vector<FitMethod> fit_methods(const FitBudget& budget) {
  std::vector<FitMethod> methods{
      {"lrcs search", lrcs_search}, {"lrcs fit", lrcs_fit}, {"GSAA, all parameters", [budget](const FitTask& task) {
                                                               return plain_gsaa(task, budget.evaluations);
                                                             }}};
  for (FitMethod& method : pagmo_methods(budget.evaluations)) methods.push_back(std::move(method));
  methods.push_back({fmt::format("Ceres, {} starts", budget.starts),
                     [budget](const FitTask& task) { return ceres_starts(task, budget.starts); }});
  return methods;
}

FitEnd one_descent(const FitBox& box, Uniform& random) {
  std::vector<double> place(box.dimensions());
  for (double& x : place) x = random.next();
  std::vector<double> start = box.values_at_place(place);
  box.problem().solve_linear(start);
  const Polished end = descend(box.problem(), start, {});
  return {end.parameters, end.evaluations + 1L};
}

}  // namespace lrcs
