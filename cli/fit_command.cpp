#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <set>

#include "base/input_error.h"
#include "base/length.h"
#include "base/nearest_name.h"
#include "base/whole_file.h"
#include "brdf/brdf_form.h"
#include "brdf/brdf_table.h"
#include "brdf/material_yaml.h"
#include "cli/commands.h"
#include "cli/fit_pictures.h"
#include "cli/flag_words.h"
#include "cli/progress_bar.h"
#include "fit/brdf_fit.h"
#include "fit/fit_text.h"

namespace lrcs {
namespace {

namespace fs = std::filesystem;

struct Flags {
  std::string data, model = "five_parameter", material, wavelength, azimuth_of_specular, value, residual = "linear",
                    incidence, pictures = "png";
  FitOptions fit;
};

std::vector<std::string> models_of(const std::string& word) {
  std::vector<std::string> names;
  for (const BrdfForm& form : brdf_forms()) names.push_back(form.name);
  if (word == "all") return names;
  if (find_brdf_form(word) != nullptr) return {word};
  throw InputError(fmt::format("--model: unknown model '{}'{} (known: all, {})", word, did_you_mean(word, names),
                               fmt::join(names, ", ")));
}

std::string one_of(const std::string& word, const std::string& flag, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), word) != words.end()) return word;
  throw InputError(fmt::format("{}: expected {}, found '{}'", flag, fmt::join(words, " or "), word));
}

MeasurementOptions measurement_options(const Flags& flags) {
  MeasurementOptions options;
  if (!flags.azimuth_of_specular.empty())
    options.azimuth_of_specular =
        one_of(flags.azimuth_of_specular, "--azimuth-of-specular", {"180", "0"}) == "180" ? 180 : 0;
  if (!flags.value.empty())
    options.value_has_cosine = one_of(flags.value, "--value", {"brdf", "brdf_cosine"}) == "brdf_cosine";
  return options;
}

std::optional<double> wavelength_asked(const Flags& flags) {
  if (flags.wavelength.empty()) return std::nullopt;
  try {
    return length_from_text(flags.wavelength);
  } catch (const std::invalid_argument& wrong) {
    throw InputError(fmt::format("--wavelength: {}", wrong.what()));
  }
}

// The one of these that was measured at the wavelength asked for, or the only one.
BrdfMeasurement chosen(const std::vector<BrdfMeasurement>& all, const Flags& flags) {
  const auto asked = wavelength_asked(flags);
  if (all.size() == 1 && (!asked || all.front().wavelength == 0.0)) {
    BrdfMeasurement only = all.front();
    only.wavelength = asked.value_or(only.wavelength);
    return only;
  }
  if (asked)
    if (const BrdfMeasurement* found = measured_at(all, *asked)) return *found;
  std::vector<std::string> known;
  known.reserve(all.size());
  for (const BrdfMeasurement& m : all) known.push_back(text_of_length(m.wavelength, "um"));
  throw InputError(asked ? fmt::format("--wavelength: {} was measured at {}, not at {}", flags.data,
                                       fmt::join(known, ", "), flags.wavelength)
                         : fmt::format("{}: measured at several wavelengths: expected --wavelength with one of {}",
                                       flags.data, fmt::join(known, ", ")));
}

bool is_at(const BrdfSample& sample, double theta_i_deg) {
  return std::abs(sample.theta_i - theta_i_deg * degree) < 0.005 * degree;
}

// All that occur, in increasing order [deg], at most 20 of them.
std::string incidences_of(const BrdfMeasurement& measurement) {
  constexpr std::size_t most = 20;
  std::set<double> all;
  for (const BrdfSample& s : measurement.samples) all.insert(std::round(100.0 * s.theta_i / degree) / 100.0);
  const std::vector<double> few(all.begin(), std::next(all.begin(), std::min(all.size(), most)));
  return fmt::format("{}{}", fmt::join(few, ", "), few.size() < all.size() ? ", ..." : "");
}

// Only the samples at these angles of incidence, each of which must occur.
void keep_incidence(BrdfMeasurement& measurement, const std::string& words) {
  if (words.empty()) return;
  const auto angles = angles_from_words(words, "--incidence", incidence_domain);
  auto& samples = measurement.samples;
  for (const double deg : angles)
    if (std::none_of(samples.begin(), samples.end(), [&](const BrdfSample& s) { return is_at(s, deg); }))
      throw InputError(
          fmt::format("--incidence: no samples at {} deg, measured were {} deg", deg, incidences_of(measurement)));
  const auto is_other = [&](const BrdfSample& s) {
    return std::none_of(angles.begin(), angles.end(), [&](double deg) { return is_at(s, deg); });
  };
  if (std::erase_if(samples, is_other) > 0) warn_of_one_incidence(measurement);
}

BrdfMeasurement read(const Flags& flags) {
  BrdfMeasurement measurement = chosen(read_brdf_measurements(flags.data, measurement_options(flags)), flags);
  keep_incidence(measurement, flags.incidence);
  return measurement;
}

fs::path facts_of(const std::string& material) {
  return fs::path(material).replace_extension(".json");
}

FitPictureFiles pictures_of(const Flags& flags) {
  return picture_files(flags.material, "." + one_of(flags.pictures, "--pictures", {"png", "svg"}));
}

// The material last: where there is one, the rest is there too.
std::vector<fs::path> write_results(const Flags& flags, const BrdfFit& fit, const BrdfMeasurement& measurement) {
  Material material = fit.material;
  material.source = fmt::format("{} fitted by lrcs to {}, E = {:.4g} %", fit.form, measurement.name, fit.e_percent);
  auto files = draw_fit_pictures(pictures_of(flags), fit, measurement, flags.fit.residual);
  const fs::path facts = facts_of(flags.material);
  write_whole_file(facts, fit_json(fit, measurement));
  write_whole_file(flags.material, material_to_yaml(material));
  files.insert(files.begin(), {flags.material, facts});
  return files;
}

void check_output(const Flags& flags) {
  const FitPictureFiles pictures = pictures_of(flags);
  if (flags.material.empty()) return;
  require_output_file(flags.material, "--output", {".yaml", ".yml"});
  for (const fs::path& file : {fs::path(flags.material), facts_of(flags.material), pictures.fit, pictures.shadowing}) {
    std::error_code none;
    if (fs::equivalent(file, flags.data, none))
      throw InputError(fmt::format("--output: would overwrite the data, '{}'", file.string()));
  }
}

void say(const BrdfMeasurement& measurement, const Common& common) {
  if (common.quiet) return;
  fmt::print(stderr, "lrcs: {}: {}, {} samples\n", measurement.name, measurement.format, measurement.samples.size());
  for (const auto& note : measurement.notes) fmt::print(stderr, "lrcs: note: {}\n", note);
  for (const auto& warning : measurement.warnings) fmt::print(stderr, "lrcs: warning: {}\n", warning);
}

// Of the measurement's warnings, which come first, all are said before.
void say(const BrdfFit& fit, const BrdfMeasurement& measurement) {
  auto warnings = brdf_warnings(fit.material.brdf);
  warnings.insert(warnings.begin(), fit.warnings.begin() + static_cast<std::ptrdiff_t>(measurement.warnings.size()),
                  fit.warnings.end());
  for (const auto& warning : warnings) fmt::print(stderr, "lrcs: warning: {}\n", warning);
}

// Of several models those with fewer parameters than there are samples that count: as many are met by any.
std::vector<BrdfFit> fitted(const std::vector<std::string>& models, const BrdfMeasurement& measurement,
                            const FitOptions& options, const Common& common) {
  const auto counts = [](const BrdfSample& s) { return s.weight > 0.0; };
  const auto samples =
      static_cast<std::size_t>(std::count_if(measurement.samples.begin(), measurement.samples.end(), counts));
  std::vector<BrdfFit> fits;
  ProgressBar bar(models.size(), "models", !common.quiet && models.size() > 1);
  for (std::size_t k = 0; k < models.size(); ++k) {
    const std::size_t parameters = find_brdf_form(models[k])->parameters.size();
    if (models.size() == 1 || parameters < std::max<std::size_t>(samples, 2))
      fits.push_back(fit_brdf(measurement, models[k], options));
    else if (!common.quiet)
      fmt::print(stderr, "lrcs: warning: {} is left out: {} samples, {} parameters\n", models[k], samples, parameters);
    bar.update(k + 1);
  }
  return fits;
}

void run(Flags& flags, const Common& common) {
  const auto models = models_of(flags.model);
  flags.fit.residual =
      one_of(flags.residual, "--residual", {"linear", "log"}) == "log" ? Residual::logarithmic : Residual::linear;
  check_output(flags);
  const BrdfMeasurement measurement = read(flags);
  say(measurement, common);
  const auto fits = fitted(models, measurement, flags.fit, common);
  const BrdfFit& best = *std::min_element(fits.begin(), fits.end(),
                                          [](const BrdfFit& a, const BrdfFit& b) { return a.criterion < b.criterion; });
  if (models.size() > 1) fmt::print("{}\n", comparison_text(fits));
  fmt::print("{}", fit_text(best));
  if (!common.quiet) say(best, measurement);
  if (flags.material.empty()) return;
  std::vector<std::string> written;
  for (const fs::path& file : write_results(flags, best, measurement)) written.push_back(file.string());
  if (common.quiet) return;
  if (!is_measured_in_plane(measurement))
    fmt::print(stderr, "lrcs: warning: no picture: no sample lies in the plane of incidence\n");
  fmt::print(stderr, "lrcs: results in {}\n", fmt::join(written, ", "));
}

// A number in [least, most]. CLI11's own lets NaN through and a seed wrap.
template <class T>
CLI::Validator number_in(T least, T most, const std::string& domain) {
  const auto complaint = [=](const std::string& word) {
    T x{};
    const auto [end, wrong] = std::from_chars(word.data(), word.data() + word.size(), x);
    const bool good = wrong == std::errc{} && end == word.data() + word.size() && x >= least && x <= most;
    return good ? std::string() : fmt::format("expected {}, found '{}'", domain, word);
  };
  return {complaint, domain};
}

void add_search_flags(CLI::App& verb, FitOptions& fit) {
  GsaaOptions& g = fit.gsaa;
  const auto add = [&](const std::string& flag, auto& value, const std::string& text, const CLI::Validator& check) {
    verb.add_option(flag, value, fmt::format("{} (default {})", text, value))->check(check)->group("Search");
  };
  const auto whole = number_in(0, 100000, "a whole number, 0 to 100000");
  const auto probability = number_in(0.0, 1.0, "a number, 0 to 1");
  add("--seed", g.seed, "Seed of the search", number_in<std::uint64_t>(0, ~0ULL, "a whole number below 2^64"));
  add("--population", g.population, "Individuals of the annealed population",
      number_in(2, 100000, "a whole number, 2 to 100000"));
  add("--generations", g.generations, "Generations", whole);
  add("--crossover", g.crossover, "Probability of two parents", probability);
  add("--mutation", g.mutation, "Probability that a coordinate is moved", probability);
  add("--step", g.step, "Such a move at the first temperature, of the search range",
      number_in(1e-6, 1.0, "a number, 1e-6 to 1"));
  add("--temperature", g.temperature, "First temperature, a relative rise of the error",
      number_in(1e-6, 1e6, "a number, 1e-6 to 1e6"));
  add("--cooling", g.cooling, "Temperature of a generation over the one before",
      number_in(1e-6, 1.0, "a number, 1e-6 to 1"));
  add("--starts", fit.starts, "Polishes from anywhere", whole);
  add("--neighbours", fit.neighbours, "Polishes around the best, a round", whole);
}

}  // namespace

void add_fit_command(CLI::App& app, Common& common) {
  const auto flags = std::make_shared<Flags>();
  CLI::App* verb = app.add_subcommand("fit", "Fits a BRDF model to goniometer data");
  verb->add_option("data", flags->data, "Measured BRDF: lrcs CSV, ALTA .dat, Zemax .bsdf, FRED, MERL .binary, tables")
      ->required();
  verb->add_option("-m,--model", flags->model, "A model, or all: compares them (default five_parameter)");
  verb->add_option("-o,--output", flags->material,
                   "Write the material (MATERIAL.yaml), the facts of the fit (.json) and pictures; of all models "
                   "that with the least information criterion");
  verb->add_option("--pictures", flags->pictures, "Of --output: png (default) or svg");
  verb->add_option("--wavelength", flags->wavelength, "Which wavelength of the file, or what the file leaves unsaid");
  verb->add_option("--azimuth-of-specular", flags->azimuth_of_specular,
                   "Where the file leaves it unsaid: the azimuth of the specular side, 180 (default) or 0 [deg]");
  verb->add_option("--value", flags->value, "Where the file leaves it unsaid: brdf (default) or brdf_cosine");
  verb->add_option("--incidence", flags->incidence, "Only these angles of incidence [deg]: A,B,C or FROM:TO:STEP");
  verb->add_option("--residual", flags->residual, "What is minimised: linear (E, default), or log");
  add_search_flags(*verb, flags->fit);
  add_common_flags(*verb, common);
  verb->callback([flags, &common] { run(*flags, common); });
}

}  // namespace lrcs
