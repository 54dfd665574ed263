#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace lrcs {

// The candidate a user most likely meant by `word`, or "".
// value: the smallest edit distance (insert, delete, change, swap neighbours), the first of equals.
// domain: a slip of the pen, which is at most a third of the word's letters (at least one, never all), or a word of
//         three letters or more that begins the candidate.
[[nodiscard]] std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

// ", did you mean 'x'?" or "".
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace lrcs
