#include "fit/thinned.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/uniform.h"

namespace lrcs {

std::vector<BrdfSample> thinned(const std::vector<BrdfSample>& samples, std::size_t count, std::uint64_t seed) {
  if (samples.size() <= count) return samples;
  std::vector<double> size(samples.size());
  for (std::size_t k = 0; k < size.size(); ++k)
    size[k] = samples[k].weight * std::pow(samples[k].f_r * std::cos(samples[k].theta_r), 2.0);
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto largest = static_cast<std::ptrdiff_t>(count / 5);
  std::nth_element(order.begin(), order.begin() + largest, order.end(),
                   [&](std::size_t a, std::size_t b) { return size[a] > size[b] || (size[a] == size[b] && a < b); });
  std::sort(order.begin(), order.begin() + largest);
  std::sort(order.begin() + largest, order.end());
  std::vector<BrdfSample> few;
  few.reserve(count);
  for (std::ptrdiff_t k = 0; k < largest; ++k) few.push_back(samples[order[static_cast<std::size_t>(k)]]);
  const auto first = static_cast<std::size_t>(largest);
  const std::size_t others = order.size() - first;
  const std::size_t stretches = count - first;
  Uniform random(seed);
  for (std::size_t k = 0; k < stretches; ++k) {
    const std::size_t begin = k * others / stretches;
    const std::size_t length = (k + 1) * others / stretches - begin;
    few.push_back(samples[order[first + begin + random.below(length)]]);
    few.back().weight *= static_cast<double>(length);
  }
  return few;
}

}  // namespace lrcs
