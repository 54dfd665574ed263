#include "view/part_returns.h"

#include <algorithm>
#include <numeric>

#include "base/compensated_sum.h"

namespace lrcs {

std::vector<double> part_returns(const FacetMesh& mesh, const std::vector<double>& facet_sigma) {
  std::vector<CompensatedSum> sums(mesh.part.names.size());
  for (std::size_t k = 0; k < mesh.size(); ++k) sums[mesh.part.of[k]].add(facet_sigma[k]);
  std::vector<double> returns(sums.size());
  std::transform(sums.begin(), sums.end(), returns.begin(), [](const CompensatedSum& sum) { return sum.value(); });
  return returns;
}

std::vector<std::uint32_t> strongest_parts(const std::vector<double>& part_sigma, std::size_t most) {
  std::vector<std::uint32_t> parts(part_sigma.size());
  std::iota(parts.begin(), parts.end(), 0);
  std::erase_if(parts, [&](std::uint32_t part) { return part_sigma[part] <= 0.0; });
  std::stable_sort(parts.begin(), parts.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return part_sigma[a] > part_sigma[b]; });
  if (parts.size() > most) parts.resize(most);
  return parts;
}

}  // namespace lrcs
