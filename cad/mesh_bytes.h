#pragma once
#include <string>
#include <string_view>

#include "mesh/facet_mesh.h"

namespace lrcs {

// A mesh as bytes and back, for another process of this program on this machine.
// law: mesh_of_bytes(bytes_of_mesh(m)) is m, bit for bit, measured. error: std::runtime_error for bytes that are none.
[[nodiscard]] std::string bytes_of_mesh(const FacetMesh& mesh);
// Takes them from the front of `bytes`.
[[nodiscard]] FacetMesh mesh_of_bytes(std::string_view& bytes);

// The same of words.
void append_words(std::string& bytes, const std::vector<std::string>& words);
[[nodiscard]] std::vector<std::string> take_words(std::string_view& bytes);

}  // namespace lrcs
