#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/direction.h"
#include "bench/method.h"

namespace lrcs {

// One run of one method in one direction.
struct Measurement {
  std::string target;
  std::size_t facets = 0;
  AspectAngles direction;
  std::string family, method, mark;
  int run = 0;
  double seconds = 0.0;
  SeenSums error;      // relative to the exact one; NaN where the method does not know that sum
  SeenSums allowed;    // Method::allowed
  double bound = 0.0;  // Method::bound; 0 where it gives none
};

struct Plan {
  std::vector<AspectAngles> directions;
  int runs = 5;               // of a method in a direction
  double long_run = 1.0;      // a method that took longer runs once a direction [s]
  double longest_run = 20.0;  // a method that would take longer, by its family's effort, is left out [s]
};

// Directions spread evenly over the sphere at random, always the same.
[[nodiscard]] std::vector<AspectAngles> seeded_directions(std::size_t count);

// All methods in all directions. Methods take turns run by run, so that what else the machine does hits all alike.
[[nodiscard]] std::vector<Measurement> measure(const std::string& target, std::size_t facets, const Methods& methods,
                                               const Plan& plan);

// Measurements, each as a line, whose error only a fault explains.
[[nodiscard]] std::vector<std::string> faults(const std::vector<Measurement>& measurements);

// One row a measurement.
void write_csv(const std::filesystem::path& file, const std::vector<Measurement>& measurements);

}  // namespace lrcs
