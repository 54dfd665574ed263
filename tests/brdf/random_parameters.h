#pragma once
#include <cmath>

#include "brdf/form_list.h"
#include "tests/brdf/sample_brdfs.h"

namespace lrcs {

// Parameters of a form anywhere in the range where a search begins; linear ones in [0.05, 0.95].
template <class Form>
forms::Values<double, Form::parameters.size()> random_parameters(RandomDirections& random) {
  forms::Values<double, Form::parameters.size()> values{};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const FormParameter& p = Form::parameters[k];
    if (p.is_linear)
      values[k] = random.uniform(0.05, 0.95);
    else if (p.scale != FormParameter::Scale::linear)
      values[k] = std::exp(random.uniform(std::log(p.from), std::log(p.to)));
    else
      values[k] = random.uniform(p.from, p.to);
  }
  return values;
}

// The list of forms as GoogleTest's.
template <class List>
struct TypesOf;
template <class... Forms>
struct TypesOf<std::tuple<Forms...>> {
  using type = testing::Types<Forms...>;
};
using EveryForm = TypesOf<FormList>::type;

}  // namespace lrcs
