#include "bench/fit_coverage.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <cstdio>

#include "bench/fit_data.h"
#include "brdf/brdf_form.h"
#include "brdf/form_list.h"
#include "brdf/library.h"
#include "fit/brdf_fit.h"

namespace lrcs {
namespace {

// Nine parameters hold all of the library, five those that were fitted with five.
bool holds(const std::string& form, const Material& material) {
  return form == forms::NineParameterForm::name || words_of(material.brdf).form->name == form;
}

// Of one parameter.
struct Coverage {
  std::string parameter;
  int determined = 0;  // repetitions in which it is called determined
  int covered = 0;     // of those: the interval holds the true value
};

std::vector<Coverage> coverage(const Material& material, const std::string& form, double noise, int repetitions) {
  std::vector<BrdfFit> fits(static_cast<std::size_t>(repetitions));
  tbb::parallel_for(std::size_t{0}, fits.size(), [&](std::size_t k) {
    FitOptions options;
    options.gsaa.seed = static_cast<std::uint64_t>(k) + 1;
    fits[k] = fit_brdf(fit_data(material, noise, options.gsaa.seed).measurement, form, options);
  });
  const std::vector<double> truth = true_parameters(material, form);
  std::vector<Coverage> all(truth.size());
  for (const BrdfFit& fit : fits)
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const FittedParameter& p = fit.parameters[k];
      all[k].parameter = p.name;
      if (!p.determined) continue;
      ++all[k].determined;
      if (std::abs(p.value - truth[k]) <= p.half_width_95) ++all[k].covered;
    }
  return all;
}

std::string text_of(const Coverage& c) {
  if (c.determined == 0) return fmt::format("{} -", c.parameter);
  return fmt::format("{} {:.1f} of {}", c.parameter, 100.0 * c.covered / c.determined, c.determined);
}

}  // namespace

void print_coverage(const std::vector<std::string>& forms, const std::vector<double>& noises, int repetitions) {
  fmt::print("\ntruth within the 95 % interval [%], of repetitions that call the parameter determined; {} a line\n",
             repetitions);
  fmt::print("{:18}{:16}{:>9}\n", "material", "form", "noise [%]");
  for (const std::string& form : forms)
    for (const Material& material : material_library()) {
      if (!holds(form, material)) continue;
      for (const double noise : noises) {
        if (!(noise > 0.0)) continue;
        fmt::print("{:18}{:16}{:>9g}", material.name, form, 100.0 * noise);
        for (const Coverage& c : coverage(material, form, noise, repetitions)) fmt::print("{:>22}", text_of(c));
        fmt::print("\n");
        std::fflush(stdout);
      }
    }
}

}  // namespace lrcs
