#include "cad/curving.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <system_error>

namespace lrcs {
namespace {

constexpr std::string_view crease = "crease:";

}  // namespace

Curving curving_from_words(const std::string& words, const Place& place) {
  if (words == "auto") return {};
  if (words == "none") return {Curving::By::nothing};
  if (words == "file_normals") return {Curving::By::file_normals};
  Curving curving{Curving::By::estimated_normals};
  if (words.starts_with(crease)) {
    const char* const end = words.data() + words.size();
    const auto [at, wrong] = std::from_chars(words.data() + crease.size(), end, curving.crease_deg);
    if (wrong == std::errc{} && at == end && curving.crease_deg >= 1.0 && curving.crease_deg <= 89.0) return curving;
  }
  throw InputError(place,
                   fmt::format("expected auto, none, file_normals or crease:ANGLE with 1..89 deg, found '{}'", words));
}

std::string text_of(const Curving& curving) {
  switch (curving.by) {
    case Curving::By::nothing:
      return "none";
    case Curving::By::estimated_normals:
      return fmt::format("crease:{}", curving.crease_deg);
    case Curving::By::file_normals:
      return "file_normals";
    default:
      return "auto";
  }
}

}  // namespace lrcs
