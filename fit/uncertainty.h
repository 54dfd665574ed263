#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "fit/descent.h"

namespace lrcs {

// What data tell of one fitted parameter.
struct ParameterError95 {
  double standard_error = 0.0;  // [unit of the parameter]; infinite where the data do not tell
  double half_width = 0.0;      // of the interval that holds the truth with a chance of 95 % [same]
  bool determined = false;
  std::string why_not;  // in words, where it is not
};

struct Uncertainty {
  std::vector<ParameterError95> parameters;
  Eigen::MatrixXd correlation;  // [1]; rows and columns of undetermined parameters as far as they have one, else 0
};

// value: standard errors of the linearised model, noise being a sum of the kinds of FitProblem::variance_basis, their
//   shares found from the residuals; corrected by how the squares rise where the parameter is held at the ends of its
//   interval and the others are fitted again, from here and from the lowest of other valleys (a parameter that ends at
//   a limit of its range makes others look sharper than they are); intervals by Student's distribution.
// A parameter is determined where it is not at an end of its range, the interval is at most half the value to each
// side, the squares rise at its ends by what the linearised model says within a factor of 1.8 (not asked of intervals
// below 1e-6 of the value, such as those of data without noise), and none of `rivals` (where other polishes of the same
// problem ended) whose squares rise by less than five times what they do at the interval's ends has it farther away
// than a valley of that shape reaches at that height, within the same factor. check: coverage of the intervals in
// tests/fit/uncertainty_test.cpp.
[[nodiscard]] Uncertainty uncertainty(const FitProblem& problem, const std::vector<double>& parameters,
                                      const std::vector<Polished>& rivals = {});

}  // namespace lrcs
