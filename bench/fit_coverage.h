#pragma once
#include <string>
#include <vector>

namespace lrcs {

// How often the 95 % intervals of fit_brdf() hold the true values, printed as a line for each material of the library,
// form of these that holds it, and noise above 0 (standard deviation of f_r over f_r [1]): of each parameter the share
// among those repetitions that call it determined, and their number. Seeds 1 to `repetitions`; on all threads.
void print_coverage(const std::vector<std::string>& forms, const std::vector<double>& noises, int repetitions);

}  // namespace lrcs
