#include "base/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace lrcs {
namespace {

constexpr std::size_t shortest_beginning = 3;  // letters: fewer begin too many names to mean one

// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other.
// source: R. A. Wagner and R. Lowrance, J. ACM 22(2), 177-183, 1975, restricted to optimal string alignment.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> d((a.size() + 1) * columns);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return d[i * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = i;
  for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  return d.back();
}

}  // namespace

std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates) {
  const std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
  std::size_t best = std::numeric_limits<std::size_t>::max();
  std::string nearest;
  for (const std::string& candidate : candidates) {
    const std::size_t length_gap = std::max(candidate.size(), word.size()) - std::min(candidate.size(), word.size());
    const std::size_t distance = length_gap > limit ? length_gap : edit_distance(word, candidate);
    const bool slip = distance <= limit && distance < word.size();
    const bool beginning = word.size() >= shortest_beginning && candidate.starts_with(word);
    if ((slip || beginning) && distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string nearest = nearest_name(word, candidates);
  return nearest.empty() ? "" : ", did you mean '" + nearest + "'?";
}

}  // namespace lrcs
