#pragma once
#include <string>
#include <vector>

namespace lrcs {

// Repetitions of a made measurement with other noise, fitted by fit_brdf().
struct CoverageCase {
  std::string material, form;  // of the library; five or nine parameters
  double noise = 0.0;          // standard deviation of f_r over f_r [1]
  int repetitions = 0;         // seeds 1, 2, ...
};

// Of one parameter of the form.
struct Coverage {
  std::string parameter;
  int determined = 0;  // repetitions in which it is called determined
  int covered = 0;     // of those: the 95 % interval holds the true value
};

// On all threads. error: invalid_argument for a form that does not hold the material.
[[nodiscard]] std::vector<Coverage> interval_coverage(const CoverageCase& c);

// Every material by every form that holds it, with every noise: measured and printed, a line each.
void print_coverage(const std::vector<std::string>& forms, const std::vector<double>& noises, int repetitions);

}  // namespace lrcs
