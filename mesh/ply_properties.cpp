#include "mesh/ply_properties.h"

#include <algorithm>

namespace lrcs {

bool is_scalar(const PlyProperty& property) {
  return !property.count_type;
}

bool is_index_list(const PlyProperty& property) {
  return property.count_type && is_integer(property.type) &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool is_word(const PlyProperty& property) {
  return is_scalar(property) && is_integer(property.type);
}

std::size_t axis_of(const PlyProperty& property, const PlyAxisNames& names) {
  if (!is_scalar(property)) return 3;
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), property.name) - names.begin());
}

}  // namespace lrcs
