#pragma once
#include <string>

#include "base/input_error.h"

namespace lrcs {

// Which curved surface the facets of a target stand for, when it is integrated.
struct Curving {
  enum class By {
    cad_surfaces,       // those of CAD files; facets of other files are flat
    nothing,            // all facets are flat
    estimated_normals,  // a model: through the facets' corners, with normals estimated there (mesh/corner_normals.h)
    file_normals,       // the same model with the normals that the file gives there (mesh/file_normals.h)
  };
  By by = By::cad_surfaces;
  double crease_deg = 0.0;  // of estimated_normals: where facets turn by more there is an edge [deg]
};

// "auto", "none", "crease:30", "file_normals". crease: 1..89 deg. error: InputError.
[[nodiscard]] Curving curving_from_words(const std::string& words, const Place& place);

// The words.
[[nodiscard]] std::string text_of(const Curving& curving);

}  // namespace lrcs
