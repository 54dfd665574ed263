#include "fit/search.h"

#include <algorithm>
#include <cmath>

#include "fit/coordinate.h"
#include "fit/gsaa.h"
#include "fit/uniform.h"

namespace lrcs {
namespace {

constexpr Patience short_patience{40, 1e-6};
constexpr int from_population = 4;
constexpr double unlike = 0.15;  // [part of the search range] in some coordinate
constexpr int tries = 8;         // places anywhere of which the best is polished
constexpr double inside = 0.02;  // [part of the search range] from its ends
constexpr double beyond = 0.5;   // the same, outside
constexpr int most_rounds = 4;
constexpr double worth_while = 1e-4;  // relative fall of the squares
constexpr int finalists = 3;
constexpr double near_best = 1.02;  // squares of a finalist over the best
constexpr double same = 1e-5;       // relative difference of squares that are those of one valley
constexpr double rival = 2.0;       // squares over the least

bool has_less(const Polished& a, const Polished& b) {
  return a.squares < b.squares;
}

class Search {
 public:
  Search(const FitProblem& problem, const FitOptions& options)
      : problem_(problem), options_(options), random_(options.gsaa.seed ^ 0x5eedU) {
    const auto parameters = problem.parameters();
    for (std::size_t k = 0; k < parameters.size(); ++k)
      if (!parameters[k].is_linear) sought_.push_back(k);
  }

  Found run(const std::vector<std::vector<double>>& starts) {
    for (const auto& start : starts) attempt(start);
    if (sought_.empty()) {
      attempt(parameters_at({}));
      return finish();
    }
    population();
    for (int k = 0; k < options_.starts; ++k) attempt(anywhere());
    for (int round = 0; round < most_rounds && neighbourhood(); ++round) {}
    return finish();
  }

 private:
  [[nodiscard]] std::vector<double> parameters_at(std::span<const double> place) const {
    std::vector<double> values(problem_.parameters().size(), 0.0);
    for (std::size_t j = 0; j < sought_.size(); ++j)
      values[sought_[j]] = value_at(problem_.parameters()[sought_[j]], place[j]);
    return values;
  }

  double error(std::span<const double> place) {
    ++evaluations_;
    auto values = parameters_at(place);
    return problem_.solve_linear(values);
  }

  // Did it fall?
  bool attempt(std::vector<double> start) {
    problem_.solve_linear(start);
    ends_.push_back(descend(problem_, start, short_patience));
    evaluations_ += ends_.back().evaluations + 1;
    const bool first = ends_.size() == 1;
    const double before = first ? 0.0 : ends_[best_].squares;
    if (first || ends_.back().squares < before) best_ = ends_.size() - 1;
    return ends_[best_].squares < before * (1.0 - worth_while);
  }

  void population() {
    const auto candidates = gsaa(sought_.size(), options_.gsaa, [&](std::span<const double> p) { return error(p); });
    std::vector<const Candidate*> taken;
    for (const Candidate& c : candidates) {
      if (taken.size() == from_population) break;
      const auto is_like = [&](const Candidate* other) { return distance(c.place, other->place) < unlike; };
      if (std::any_of(taken.begin(), taken.end(), is_like)) continue;
      taken.push_back(&c);
      attempt(parameters_at(c.place));
    }
  }

  static double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
  }

  std::vector<double> anywhere() {
    std::vector<double> place(sought_.size()), best;
    double least = 0.0;
    for (int k = 0; k < tries; ++k) {
      for (double& x : place) x = random_.next();
      const double found = error(place);
      if (!best.empty() && found >= least) continue;
      least = found;
      best = place;
    }
    return parameters_at(best);
  }

  // Near both ends of the search range; and where the parameter may go on, beyond.
  static std::vector<double> near_ends(const FormParameter& p) {
    std::vector<double> values{value_at(p, inside), value_at(p, 1.0 - inside)};
    if (coordinate_of(p, p.least) < -inside) values.push_back(value_at(p, -beyond));
    if (coordinate_of(p, p.most) > 1.0 + inside) values.push_back(value_at(p, 1.0 + beyond));
    return values;
  }

  // Did any fall?
  bool neighbourhood() {
    bool fell = false;
    for (const std::size_t k : sought_)
      for (const double value : near_ends(problem_.parameters()[k])) {
        auto start = ends_[best_].parameters;
        start[k] = value;
        fell |= attempt(std::move(start));
      }
    for (int k = 0; k < options_.neighbours; ++k) {
      auto start = ends_[best_].parameters;
      for (std::size_t moves = 1 + random_.below(3); moves > 0; --moves) {
        const std::size_t j = sought_[random_.below(sought_.size())];
        start[j] = value_at(problem_.parameters()[j], random_.next());
      }
      fell |= attempt(std::move(start));
    }
    return fell;
  }

  Found finish() {
    std::stable_sort(ends_.begin(), ends_.end(), has_less);
    std::vector<Polished> finished;
    double last = -1.0;
    for (const Polished& end : ends_) {
      if (finished.size() == finalists || end.squares > near_best * ends_.front().squares) break;
      if (end.squares <= last * (1.0 + same)) continue;
      last = end.squares;
      finished.push_back(descend(problem_, end.parameters, {}));
      evaluations_ += finished.back().evaluations;
    }
    Found found{*std::min_element(finished.begin(), finished.end(), has_less), {}};
    found.evaluations = evaluations_;
    last = -1.0;
    for (const Polished& end : ends_) {
      if (end.squares > rival * found.squares) break;
      if (end.squares > last * (1.0 + same)) found.rivals.push_back(end);
      last = found.rivals.back().squares;
    }
    return found;
  }

  const FitProblem& problem_;
  const FitOptions& options_;
  Uniform random_;
  std::vector<std::size_t> sought_;  // parameters that are not linear
  std::vector<Polished> ends_;
  std::size_t best_ = 0;  // of ends_
  int evaluations_ = 0;
};

}  // namespace

Found search(const FitProblem& problem, const FitOptions& options, const std::vector<std::vector<double>>& starts) {
  return Search(problem, options).run(starts);
}

}  // namespace lrcs
