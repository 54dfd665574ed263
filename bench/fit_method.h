#pragma once
#include <functional>
#include <string>
#include <vector>

#include "bench/fit_box.h"
#include "bench/fit_data.h"

namespace lrcs {

// What a method is given.
struct FitTask {
  std::string form;
  const FitData& data;
  const FitBox& box;
};

// Where it ended.
struct FitEnd {
  std::vector<double> parameters;
  long evaluations = 0;  // of all residuals, with their derivatives or without
};

struct FitMethod {
  std::string name;
  std::function<FitEnd(const FitTask&)> run;  // takes its random numbers from the data's seed
};

// How much the methods may do beside lrcs.
struct FitBudget {
  int evaluations = 40000;  // of a method without derivatives
  int starts = 100;         // of a multi-start
};

}  // namespace lrcs
