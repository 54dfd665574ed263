#include "bench/honest_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "bench/median.h"
#include "brdf/library.h"
#include "lrcs/aspect.h"
#include "lrcs/sampled_sections.h"

namespace lrcs {
namespace {

std::vector<AspectAngles> directions(bool round, std::size_t count) {
  std::mt19937_64 random(round ? 21 : 22);
  const auto turned = [&](double step, double steps) {
    const double part = static_cast<double>(random() >> 11U) * 0x1p-53;
    return round ? step * std::floor(part * steps) : step * steps * part;
  };
  std::vector<AspectAngles> found;
  for (const double step : {10.0, 15.0, 30.0, 45.0})
    for (std::size_t k = 0; k < count; ++k)
      found.push_back({turned(step, 360.0 / step), turned(step, 180.0 / step + (round ? 1.0 : 0.0)) - 90.0});
  return found;
}

std::vector<Receiver> receivers(bool bistatic) {
  if (!bistatic) return {Receiver{}};
  std::vector<Receiver> found;
  for (const double apart : {40.0, 90.0})
    for (const auto plane : {Receiver::Plane::azimuth, Receiver::Plane::elevation})
      found.push_back({Receiver::Kind::bistatic, {}, apart, plane});
  return found;
}

class Comparison {
 public:
  Comparison(const Target& target, const Visibility& visibility, double relative, bool bistatic)
      : target_(target), visibility_(visibility), sampled_(target, relative, bistatic) {}

  void compare(const AspectAngles& transmitter, const Receiver& receiver) {
    const Aspect aspect = aspect_of(transmitter, receiver);
    ++rows_;
    const auto found = sampled_.section(aspect.to_transmitter, aspect.to_receiver);
    if (!found) return;
    const CrossSection exact = cross_section(target_, visibility_, aspect.to_transmitter, aspect.to_receiver);
    const double error = std::abs(found->sigma.value - exact.sigma.value);
    over_error_.push_back(found->sigma.bound / error);
    if (error > found->sigma.bound + exact.sigma.bound)
      passed_ += fmt::format("  ERROR PASSES ITS BOUND: azimuth {} deg, elevation {} deg, receiver {} deg, {} deg\n",
                             aspect.transmitter.azimuth_deg, aspect.transmitter.elevation_deg,
                             aspect.receiver.azimuth_deg, aspect.receiver.elevation_deg);
  }

  [[nodiscard]] std::string text() const {
    std::string text = fmt::format("{:8}{:10}", rows_, over_error_.size());
    if (over_error_.empty()) return text + "\n";
    const double least = *std::min_element(over_error_.begin(), over_error_.end());
    return text + fmt::format("{:12.1f}{:10.1f}\n", least, median(over_error_)) + passed_;
  }

 private:
  const Target& target_;
  const Visibility& visibility_;
  SampledSections sampled_;
  std::size_t rows_ = 0;
  std::vector<double> over_error_;
  std::string passed_;
};

}  // namespace

std::string honest_bounds_text(const FacetMesh& mesh, bool is_short) {
  const Target target{mesh, {*find_in_library("metal-skin-5p")}, std::vector<std::uint32_t>(mesh.size(), 0)};
  const Visibility visibility(target.mesh);
  std::string text = fmt::format("  {:38}{:>8}{:>10}{:>12}{:>10}\n", "bounds of relative rows", "rows", "sampled",
                                 "bound/err", "median");
  for (const double relative : {1e-2, 1e-3})
    for (const bool bistatic : {false, true})
      for (const bool round : {false, true}) {
        if (!SampledSections::may_pay(target, relative)) continue;
        Comparison comparison(target, visibility, relative, bistatic);
        for (const AspectAngles& transmitter : directions(round, is_short ? 1 : 4))
          for (const Receiver& receiver : receivers(bistatic)) comparison.compare(transmitter, receiver);
        const std::string what = fmt::format("{:g}, {}, {} angles", relative, bistatic ? "bistatic" : "monostatic",
                                             round ? "round" : "random");
        text += fmt::format("  {:38}", what) + comparison.text();
      }
  return text;
}

}  // namespace lrcs
