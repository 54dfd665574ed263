#include "fit/gsaa.h"

#include <algorithm>
#include <cmath>

#include "fit/uniform.h"

namespace lrcs {
namespace {

// Back into [0, 1] by reflection at its ends.
double folded(double x) {
  return std::abs(std::remainder(x, 2.0));
}

class Annealing {
 public:
  Annealing(std::size_t dimensions, const GsaaOptions& options,
            const std::function<double(std::span<const double>)>& error)
      : dimensions_(dimensions), options_(options), error_(error), random_(options.seed) {}

  std::vector<Candidate> run() {
    scatter();
    double temperature = options_.temperature;
    for (int g = 0; g < options_.generations; ++g) {
      generation(temperature);
      temperature *= options_.cooling;
    }
    population_.push_back(best_);
    std::stable_sort(population_.begin(), population_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.error < b.error; });
    return population_;
  }

 private:
  // Latin hypercube: each coordinate takes each of `population` layers once.
  void scatter() {
    const auto count = static_cast<std::size_t>(options_.population);
    population_.assign(count, Candidate{std::vector<double>(dimensions_), 0.0});
    for (std::size_t d = 0; d < dimensions_; ++d) {
      std::vector<std::size_t> layer(count);
      for (std::size_t k = 0; k < count; ++k) layer[k] = k;
      for (std::size_t k = count; k > 1; --k) std::swap(layer[k - 1], layer[random_.below(k)]);
      for (std::size_t k = 0; k < count; ++k)
        population_[k].place[d] = (static_cast<double>(layer[k]) + random_.next()) / static_cast<double>(count);
    }
    for (Candidate& c : population_) judge(c);
    best_ = *std::min_element(population_.begin(), population_.end(),
                              [](const Candidate& a, const Candidate& b) { return a.error < b.error; });
  }

  void judge(Candidate& c) { c.error = error_(c.place); }

  const Candidate& parent() {
    const Candidate& a = population_[random_.below(population_.size())];
    const Candidate& b = population_[random_.below(population_.size())];
    return a.error <= b.error ? a : b;
  }

  void generation(double temperature) {
    for (Candidate& self : population_) {
      Candidate child = offspring(self, temperature);
      judge(child);
      if (child.error < best_.error) best_ = child;
      if (is_accepted(child.error, self.error, temperature)) self = std::move(child);
    }
  }

  Candidate offspring(const Candidate& self, double temperature) {
    Candidate child = self;
    if (random_.next() < options_.crossover) cross(child, parent(), parent());
    const double step = options_.step * std::sqrt(temperature / options_.temperature);
    for (double& x : child.place)
      if (random_.next() < options_.mutation) x = folded(x + step * (2.0 * random_.next() - 1.0));
    return child;
  }

  // Between the parents and somewhat beyond, each coordinate by itself.
  void cross(Candidate& child, const Candidate& a, const Candidate& b) {
    for (std::size_t d = 0; d < dimensions_; ++d) {
      const double share = 1.5 * random_.next() - 0.25;
      child.place[d] = folded(a.place[d] + share * (b.place[d] - a.place[d]));
    }
  }

  bool is_accepted(double child, double self, double temperature) {
    const double chance = random_.next();
    if (child <= self) return true;
    const double rise = (child - self) / (self + best_.error);
    return chance < std::exp(-rise / temperature);
  }

  std::size_t dimensions_;
  const GsaaOptions& options_;
  const std::function<double(std::span<const double>)>& error_;
  Uniform random_;
  std::vector<Candidate> population_;
  Candidate best_;
};

}  // namespace

std::vector<Candidate> gsaa(std::size_t dimensions, const GsaaOptions& options,
                            const std::function<double(std::span<const double>)>& error) {
  return Annealing(dimensions, options, error).run();
}

}  // namespace lrcs
