#include "mesh/polygon_words.h"

#include <limits>

namespace lrcs {

void PolygonWords::set(std::size_t polygon, std::string_view word) {
  const auto [entry, is_new] = known_.try_emplace(std::string(word), static_cast<std::uint32_t>(words_.size()));
  if (is_new) words_.emplace_back(word);
  if (of_.size() <= polygon) of_.resize(polygon + 1, 0);
  of_[polygon] = entry->second;
}

FacetNames PolygonWords::of_facets(const FacetMesh& mesh) const {
  constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(words_.size(), unused);
  FacetNames told;
  told.of.reserve(mesh.size());
  for (const std::uint32_t polygon : mesh.source_facet) {
    const std::uint32_t word = polygon < of_.size() ? of_[polygon] : 0;
    if (number[word] == unused) {
      number[word] = static_cast<std::uint32_t>(told.names.size());
      told.names.push_back(words_[word]);
    }
    told.of.push_back(number[word]);
  }
  return told;
}

}  // namespace lrcs
