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

std::string line(const CoverageCase& c, const std::vector<Coverage>& all) {
  std::string text = fmt::format("{:18}{:16}{:>4}", c.material, c.form.substr(0, c.form.find('_')),
                                 fmt::format("{:g}", 100.0 * c.noise));
  for (const Coverage& p : all) {
    const std::string share =
        p.determined == 0 ? "-" : fmt::format("{:.1f}", 100.0 * p.covered / static_cast<double>(p.determined));
    text += fmt::format("{:>16}", fmt::format("{} {} of {}", p.parameter, share, p.determined));
  }
  return text + "\n";
}

}  // namespace

std::vector<Coverage> interval_coverage(const CoverageCase& c) {
  const Material& material = *find_in_library(c.material);
  std::vector<BrdfFit> fits(static_cast<std::size_t>(c.repetitions));
  tbb::parallel_for(std::size_t{0}, fits.size(), [&](std::size_t k) {
    FitOptions options;
    options.gsaa.seed = static_cast<std::uint64_t>(k) + 1;
    fits[k] = fit_brdf(fit_data(material, c.noise, options.gsaa.seed).measurement, c.form, options);
  });
  const std::vector<double> truth = true_parameters(fit_data(material, 0.0, 1), c.form);
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

void print_coverage(const std::vector<std::string>& forms, const std::vector<double>& noises, int repetitions) {
  fmt::print("\ntruth within the 95 % interval [%], of repetitions that call the parameter determined; {} a line\n",
             repetitions);
  fmt::print("{:18}{:16}{:>4}\n", "material", "form", "noise [%]");
  for (const std::string& form : forms)
    for (const Material& material : material_library()) {
      if (!holds(form, material)) continue;
      for (const double noise : noises) {
        if (!(noise > 0.0)) continue;
        const CoverageCase c{material.name, form, noise, repetitions};
        fmt::print("{}", line(c, interval_coverage(c)));
        std::fflush(stdout);
      }
    }
}

}  // namespace lrcs
