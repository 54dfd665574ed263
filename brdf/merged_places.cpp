#include "brdf/merged_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace lrcs {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

using GridCell = std::array<std::int64_t, 3>;

struct GridCellHash {
  std::size_t operator()(const GridCell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t k : cell) hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15U;
    return hash ^ (hash >> 32U);
  }
};

// Places in cells a few tolerances wide: whoever is near lies in the cells of the corners of a box about the place.
class KnownPlaces {
 public:
  explicit KnownPlaces(double tolerance) : tolerance_(tolerance) {}

  // The place near this one; else this one, added.
  std::size_t find_or_add(const Vec3& place) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const auto side = [&](unsigned axis) { return (corner >> axis & 1U) != 0 ? tolerance_ : -tolerance_; };
      const Vec3 at = place + Vec3(side(0), side(1), side(2));
      if (const std::size_t near = near_in(cell_of(at), place); near != none) return near;
    }
    const auto [entry, is_new] = first_in_.try_emplace(cell_of(place), none);
    next_.push_back(entry->second);
    entry->second = places_.size();
    places_.push_back(place);
    return entry->second;
  }

  [[nodiscard]] const std::vector<Vec3>& places() const { return places_; }

 private:
  [[nodiscard]] GridCell cell_of(const Vec3& place) const {
    const double width = 4.0 * tolerance_;
    const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / width)); };
    return {index(place.x()), index(place.y()), index(place.z())};
  }

  [[nodiscard]] std::size_t near_in(const GridCell& cell, const Vec3& place) const {
    const auto found = first_in_.find(cell);
    if (found == first_in_.end()) return none;
    for (std::size_t k = found->second; k != none; k = next_[k])
      if ((places_[k] - place).norm() <= tolerance_) return k;
    return none;
  }

  double tolerance_;
  std::unordered_map<GridCell, std::size_t, GridCellHash> first_in_;
  std::vector<Vec3> places_;
  std::vector<std::size_t> next_;  // in the same cell
};

}  // namespace

MergedPlaces merge_places(const PlacedValues& given, double tolerance) {
  MergedPlaces result;
  KnownPlaces known(tolerance);
  std::vector<std::size_t> place_of;
  std::vector<int> count;
  auto& [places, values, weights] = result.merged;
  for (std::size_t k = 0; k < given.places.size(); ++k) {
    const std::size_t place = known.find_or_add(given.places[k]);
    place_of.push_back(place);
    if (place == values.size()) {
      values.push_back(given.values[k]);
      weights.push_back(given.weights[k]);
      count.push_back(1);
      continue;
    }
    weights[place] += given.weights[k];
    values[place] += given.weights[k] / weights[place] * (given.values[k] - values[place]);
    ++count[place];
  }
  places = known.places();
  double squares = 0.0;
  double of_means = 0.0;
  for (std::size_t k = 0; k < given.places.size(); ++k) {
    const double mean = values[place_of[k]];
    if (count[place_of[k]] < 2) continue;
    squares += (given.values[k] - mean) * (given.values[k] - mean);
    of_means += mean * mean;
  }
  result.repeated = static_cast<std::size_t>(std::count_if(count.begin(), count.end(), [](int n) { return n > 1; }));
  if (of_means > 0.0) result.spread = std::sqrt(squares / of_means);
  return result;
}

}  // namespace lrcs
