#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "brdf/brdf.h"
#include "brdf/form_list.h"

namespace lrcs {

// One way to write a model down: what `model:` names in a scene file. A model may have several: Wu's has two.
struct BrdfForm {
  std::string name;
  std::string title;  // in a picture
  std::string description;
  std::vector<std::string> parameters;  // keys, in the order of the values
  bool has_azimuth_of_specular = false;
  // Throws ParameterError for a value outside its domain. values: one a parameter.
  Brdf (*make)(const std::vector<double>& values, int azimuth_of_specular) = nullptr;
};

// All forms, in the order of brdf/form_list.h.
[[nodiscard]] const std::vector<BrdfForm>& brdf_forms();

// The form of that name, or nullptr.
[[nodiscard]] const BrdfForm* find_brdf_form(std::string_view name);

// A BRDF written down, in the form with the fewest parameters that holds it; Tabulated has none: form is nullptr.
// law: form->make(values, azimuth_of_specular) gives the same BRDF back.
struct BrdfWords {
  const BrdfForm* form = nullptr;
  std::vector<double> values;
  int azimuth_of_specular = 180;  // [deg] 180 or 0; of no effect where the form has none
};
[[nodiscard]] BrdfWords words_of(const Brdf& brdf);

}  // namespace lrcs
