#include "bench/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>

#include "base/whole_file.h"
#include "bench/stopwatch.h"

namespace lrcs {
namespace {

// What methods took so far, and what that lets one expect.
class Patience {
 public:
  explicit Patience(const Plan& plan) : plan_(plan) {}

  [[nodiscard]] bool allows(const Method& method, int run) const {
    const auto own = longest_.find(method.name);
    if (own != longest_.end()) return own->second <= plan_.longest_run && (run == 0 || own->second <= plan_.long_run);
    const auto family = an_effort_.find(method.family);
    return family == an_effort_.end() || family->second * method.effort <= plan_.longest_run;
  }
  [[nodiscard]] bool is_quick(const Method& method) const {
    constexpr double quick = 0.02;
    const auto own = longest_.find(method.name);
    return own != longest_.end() && own->second < quick;
  }
  void note(const Method& method, double seconds) {
    longest_[method.name] = std::max(longest_[method.name], seconds);
    an_effort_[method.family] = seconds / method.effort;
  }

 private:
  const Plan& plan_;
  std::map<std::string, double> longest_, an_effort_;  // [s]
};

void measure_direction(const Methods& methods, const Plan& plan, Measurement row, Patience& patience,
                       std::vector<Measurement>& rows) {
  const Vec3 d = direction_of(row.direction);
  SeenSums truth, deviation;
  std::map<std::string, SeenSums> errors;
  std::map<std::string, double> bounds;
  for (row.run = 0; row.run < plan.runs; ++row.run)
    for (const Method& method : methods.all) {
      const bool is_truth = &method == &methods.all.front();
      if (!patience.allows(method, row.run) && !(is_truth && row.run == 0)) continue;
      // As in a sweep, where the row before is of the same method, and not another that has emptied the caches.
      if (patience.is_quick(method)) method.look(d);
      row.seconds = seconds_of([&] { method.look(d); });
      patience.note(method, row.seconds);
      if (row.run == 0) {
        const SeenSums found = method.found(d);
        if (is_truth) {
          truth = found;
          deviation = quotient(methods.deviation(d), truth);
        }
        errors[method.name] = relative_errors(found, truth);
        bounds[method.name] = method.bound ? method.bound() : 0.0;
      }
      row.family = method.family;
      row.method = method.name;
      row.mark = method.mark;
      row.error = errors[method.name];
      row.bound = bounds[method.name];
      row.allowed = {method.allowed(deviation.sigma_lambert), method.allowed(deviation.sigma_wu),
                     method.allowed(deviation.seen_area)};
      rows.push_back(row);
    }
}

}  // namespace

std::vector<AspectAngles> seeded_directions(std::size_t count) {
  std::mt19937_64 random(5);
  const auto share = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  std::vector<AspectAngles> directions;
  for (std::size_t k = 0; k < count; ++k) {
    const double azimuth = 360.0 * share();
    directions.push_back({azimuth, std::asin(2.0 * share() - 1.0) / degree});
  }
  return directions;
}

std::vector<Measurement> measure(const std::string& target, std::size_t facets, const Methods& methods,
                                 const Plan& plan) {
  std::vector<Measurement> rows;
  Patience patience(plan);
  Measurement row;
  row.target = target;
  row.facets = facets;
  for (const AspectAngles& direction : plan.directions) {
    row.direction = direction;
    measure_direction(methods, plan, row, patience, rows);
  }
  return rows;
}

std::vector<std::string> faults(const std::vector<Measurement>& measurements) {
  std::vector<std::string> lines;
  for (const Measurement& m : measurements) {
    double worst = m.bound > 0.0 ? m.error.sigma_wu / m.bound : 0.0;
    for (const double part : {m.error.sigma_lambert / m.allowed.sigma_lambert, m.error.sigma_wu / m.allowed.sigma_wu,
                              m.error.seen_area / m.allowed.seen_area})
      worst = std::fmax(worst, part);  // passes over what is not known
    if (m.run > 0 || worst <= 1.0) continue;
    lines.push_back(fmt::format("{}, azimuth {:.1f} deg, elevation {:.1f} deg: {}: {:.1f} times the error allowed",
                                m.target, m.direction.azimuth_deg, m.direction.elevation_deg, m.method, worst));
  }
  return lines;
}

void write_csv(const std::filesystem::path& file, const std::vector<Measurement>& measurements) {
  std::string text =
      "target,facets,azimuth_deg,elevation_deg,method,run,seconds,error_sigma_lambert,error_sigma_wu,error_seen_area\n";
  for (const Measurement& m : measurements)
    fmt::format_to(std::back_inserter(text), "{},{},{:.6f},{:.6f},\"{}\",{},{:.6e},{:.3e},{:.3e},{:.3e}\n", m.target,
                   m.facets, m.direction.azimuth_deg, m.direction.elevation_deg, m.method, m.run, m.seconds,
                   m.error.sigma_lambert, m.error.sigma_wu, m.error.seen_area);
  write_whole_file(file, text);
}

}  // namespace lrcs
