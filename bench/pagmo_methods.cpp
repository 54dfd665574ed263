#include "bench/pagmo_methods.h"

#include <algorithm>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/simulated_annealing.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

namespace lrcs {
namespace {

// The problem as pagmo asks for it.
class BoxProblem {
 public:
  BoxProblem() = default;
  explicit BoxProblem(const FitBox& box) : box_(&box) {}

  [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& place) const {
    return {box_->squares_at(place)};
  }
  [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const std::size_t size = box_ != nullptr ? box_->dimensions() : 1;
    return {pagmo::vector_double(size, 0.0), pagmo::vector_double(size, 1.0)};
  }

 private:
  const FitBox* box_ = nullptr;
};

FitEnd evolve(const FitTask& task, const pagmo::algorithm& algorithm, unsigned population) {
  const auto seed = static_cast<unsigned>(task.data.seed);
  const pagmo::population start(pagmo::problem(BoxProblem(task.box)), population, seed);
  const pagmo::population end = algorithm.evolve(start);
  return {task.box.values_at_place(end.champion_x()), static_cast<long>(end.get_problem().get_fevals())};
}

constexpr unsigned adjustments = 10, steps = 20;  // of annealing, a temperature

FitEnd annealing(const FitTask& task, unsigned budget) {
  const unsigned of_temperature = adjustments * steps * static_cast<unsigned>(task.box.dimensions());
  const unsigned temperatures = std::max(budget / of_temperature, 2U);
  constexpr double first_temperature = 1.0, last_temperature = 1e-9;  // of E/100
  const auto seed = static_cast<unsigned>(task.data.seed);
  return evolve(task,
                pagmo::algorithm(pagmo::simulated_annealing(first_temperature, last_temperature, temperatures,
                                                            adjustments, steps, 1.0, seed)),
                1);
}

constexpr double never = 0.0;  // stop for want of progress

// Besides the first population.
unsigned generations(unsigned budget, unsigned population) {
  return std::max(budget / population, 2U) - 1;
}

FitEnd evolution(const FitTask& task, unsigned budget) {
  constexpr unsigned population = 20;
  const auto seed = static_cast<unsigned>(task.data.seed);
  const pagmo::de1220 algorithm(generations(budget, population), pagmo::de1220_statics<void>::allowed_variants, 1,
                                never, never, false, seed);
  return evolve(task, pagmo::algorithm(algorithm), population);
}

FitEnd covariance(const FitTask& task, unsigned budget) {
  constexpr unsigned population = 64;
  constexpr double its_own = -1.0, first_step = 0.5;
  const auto seed = static_cast<unsigned>(task.data.seed);
  const pagmo::cmaes algorithm(generations(budget, population), its_own, its_own, its_own, its_own, first_step, never,
                               never, false, true, seed);
  return evolve(task, pagmo::algorithm(algorithm), population);
}

}  // namespace

std::vector<FitMethod> pagmo_methods(int evaluations) {
  const auto budget = static_cast<unsigned>(evaluations);
  return {{"pagmo annealing", [budget](const FitTask& task) { return annealing(task, budget); }},
          {"pagmo de1220", [budget](const FitTask& task) { return evolution(task, budget); }},
          {"pagmo CMA-ES", [budget](const FitTask& task) { return covariance(task, budget); }}};
}

}  // namespace lrcs
