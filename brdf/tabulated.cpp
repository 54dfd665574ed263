#include "brdf/tabulated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "brdf/direction_at.h"
#include "brdf/linear_interpolant.h"
#include "brdf/merged_places.h"
#include "brdf/pair_place.h"

namespace lrcs {
namespace {

constexpr double tolerance = 1e-6;         // [rad] what files with seven digits leave of an angle
constexpr double grazing = 1e-12;          // cosine
constexpr double rounding = 64 * 0x1p-53;  // [rad] of a place
constexpr double rounding_of_cosine = 8 * 0x1p-53;

// Of values measured more than once: beyond it the surface is perhaps not isotropic, or was not well aligned.
constexpr double doubtful_spread = 0.1;

// Rounding does not lift places off the plane of incidence, or off that across it.
double snapped(double coordinate) {
  return coordinate < tolerance ? 0.0 : coordinate;
}

Vec3 place_of(const BrdfSample& s) {
  const Vec3 place = pair_place(direction_at(s.theta_i, 0.0), direction_at(s.theta_r, s.phi), Vec3::UnitZ());
  return {place.x(), snapped(place.y()), snapped(place.z())};
}

PlacedValues placed(const std::vector<BrdfSample>& samples) {
  PlacedValues values;
  for (const BrdfSample& s : samples) {
    if (s.weight <= 0.0) continue;
    values.places.push_back(place_of(s));
    values.values.push_back(s.f_r);
    values.weights.push_back(s.weight);
  }
  return values;
}

// What a place stands for, on the other sides of the folds (brdf/pair_place.h): its mirror images.
std::vector<Vec3> images_of(const Vec3& p) {
  std::vector<Vec3> images;
  if (p.y() > tolerance) images.emplace_back(p.x(), -p.y(), p.z());
  if (p.z() > tolerance) images.emplace_back(p.x(), p.y(), -p.z());
  if (p.y() > tolerance && p.z() > tolerance) images.emplace_back(p.x(), -p.y(), -p.z());
  return images;
}

// Few measurements hold just the pairs on the folds, such as the retro direction itself: the images of the samples next
// to the folds are put beside the samples, so that what lies between them is measured.
LinearInterpolant interpolant_of(const MergedPlaces& merged) {
  PlacedValues all = merged.merged;
  LinearInterpolant folded(all.places, all.values, tolerance);
  const std::size_t own = all.places.size();
  for (const auto& [place, value] : folded.corners_toward_folds())
    for (const Vec3& image : images_of(place)) {
      if (!folded.is_level(image)) continue;
      all.places.push_back(image);
      all.values.push_back(value);
    }
  return all.places.size() == own ? folded : LinearInterpolant(all.places, all.values, tolerance);
}

void require_samples(const BrdfMeasurement& measurement, const Place& place) {
  const auto& samples = measurement.samples;
  if (samples.size() > Tabulated::most_samples)
    throw InputError(place, fmt::format("{} samples, expected at most {} for a tabulated material", samples.size(),
                                        Tabulated::most_samples));
  if (std::none_of(samples.begin(), samples.end(), [](const BrdfSample& s) { return s.weight > 0.0; }))
    throw InputError(place, "expected a sample of a weight above 0 for a tabulated material");
}

std::string note_of_shape(int dimension) {
  constexpr std::string_view only = "the samples fill";
  switch (dimension) {
    case 0:
      return "there is one place that was measured: all other directions are outside";
    case 1:
      return fmt::format("{} a line (such as retro-reflection only): directions off it are outside", only);
    case 2:
      return fmt::format("{} a plane (such as that of incidence): directions off it are outside", only);
    default:
      return "";
  }
}

// Where the values between which retro-reflection is drawn differ most.
std::optional<std::string> warning_of_gaps(const LinearInterpolant& f_r) {
  constexpr double doubtful = 5.0;  // largest over least: of an exponential fall the line is a third off half way
  LinearInterpolant::Span worst{1.0, 1.0};
  int where = 0;
  for (int deg = 0; deg < 90; ++deg) {
    const auto span = f_r.span(pair_place_retro(std::cos(deg * degree)));
    if (!span || !(span->largest * worst.least > worst.largest * span->least)) continue;
    worst = *span;
    where = deg;
  }
  if (!(worst.largest > doubtful * worst.least)) return std::nullopt;
  return fmt::format(
      "samples are far apart for how f_r changes: at retro, theta = {} deg, it is drawn between values of {:.3g} and "
      "{:.3g} /sr: a monostatic result there is a guess",
      where, worst.least, worst.largest);
}

// Without the samples.
BrdfMeasurement described(const BrdfMeasurement& measurement, std::size_t without_weight, const MergedPlaces& merged,
                          const LinearInterpolant& f_r) {
  BrdfMeasurement words{measurement.name,  measurement.format,  measurement.wavelength, {},
                        measurement.notes, measurement.warnings};
  const auto note = [&](std::string sentence) { words.notes.push_back(std::move(sentence)); };
  note("f_r is taken to be isotropic, reciprocal and its own mirror image, and linear between the samples");
  if (without_weight > 0) note(fmt::format("{} samples of weight 0 do not count", without_weight));
  if (merged.repeated > 0)
    (merged.spread < doubtful_spread ? words.notes : words.warnings)
        .push_back(fmt::format(
            "{} places were measured more than once, exchanged or mirrored ones too: their mean counts, from which the "
            "values differ by {:.2g} % (root mean square)",
            merged.repeated, 100.0 * merged.spread));
  if (f_r.dimension() < 3) note(note_of_shape(f_r.dimension()));
  if (auto warning = warning_of_gaps(f_r)) words.warnings.push_back(std::move(*warning));
  return words;
}

}  // namespace

std::string_view word_of(Outside outside) {
  switch (outside) {
    case Outside::nearest:
      return "nearest";
    case Outside::zero:
      return "zero";
    default:
      return "error";
  }
}

struct Tabulated::Table {
  BrdfMeasurement measurement;
  MeasuredFile file;
  std::size_t samples = 0, places = 0;
  double largest = 0.0;
  LinearInterpolant f_r;
};

Tabulated::Tabulated(const BrdfMeasurement& measurement, Outside outside, const MeasuredFile& file)
    : outside_(outside) {
  require_samples(measurement, Place{file.path.empty() ? measurement.name : file.path});
  const PlacedValues all = placed(measurement.samples);
  const MergedPlaces merged = merge_places(all, tolerance);
  const auto& [places, values, weights] = merged.merged;
  LinearInterpolant f_r = interpolant_of(merged);
  const std::size_t without_weight = measurement.samples.size() - all.places.size();
  table_ = std::make_shared<const Table>(Table{described(measurement, without_weight, merged, f_r), file,
                                               all.places.size(), places.size(),
                                               *std::max_element(values.begin(), values.end()), std::move(f_r)});
}

double Tabulated::largest() const {
  return table_->largest;
}

Tabulated Tabulated::with(Outside outside) const {
  Tabulated other = *this;
  other.outside_ = outside;
  return other;
}

const BrdfMeasurement& Tabulated::measurement() const {
  return table_->measurement;
}

const MeasuredFile& Tabulated::file() const {
  return table_->file;
}

std::string Tabulated::description() const {
  return fmt::format("tabulated file={} format=\"{}\" samples={} places={} outside={}", table_->measurement.name,
                     table_->measurement.format, samples(), places(), word_of(outside_));
}

std::size_t Tabulated::samples() const {
  return table_->samples;
}

std::size_t Tabulated::places() const {
  return table_->places;
}

int Tabulated::dimension() const {
  return table_->f_r.dimension();
}

std::optional<double> Tabulated::f_r_at(const Vec3& place, double least_cosine) const {
  if (outside_ == Outside::nearest) return table_->f_r.nearest(place);
  const auto measured = table_->f_r.at(place);
  if (measured) return measured;
  if (outside_ == Outside::zero) return 0.0;
  return least_cosine < grazing ? std::optional(table_->f_r.nearest(place)) : std::nullopt;
}

double Tabulated::value(const Vec3& wi, const Vec3& wr, const Vec3& n) const {
  const double cos_i = std::min(wi.dot(n), 1.0);
  const double cos_r = std::min(wr.dot(n), 1.0);
  if (!is_above(cos_i) || !is_above(cos_r)) return 0.0;
  const auto f_r = f_r_at(pair_place(wi, wr, n), std::min(cos_i, cos_r));
  if (!f_r) complain(wi, wr, n);
  return *f_r * (cos_i * cos_r);
}

double Tabulated::value_retro(double cosine) const {
  if (!is_above(cosine)) return 0.0;
  const double c = std::min(cosine, 1.0);
  const auto f_r = f_r_at(pair_place_retro(c), c);
  if (!f_r) {
    const Vec3 w(std::sqrt((1.0 - c) * (1.0 + c)), 0.0, c);
    complain(w, w, Vec3::UnitZ());
  }
  return *f_r * (c * c);
}

void Tabulated::complain(const Vec3& wi, const Vec3& wr, const Vec3& n) const {
  const auto zenith = [&](const Vec3& w) { return std::atan2(w.cross(n).norm(), w.dot(n)) / degree; };
  const Vec3 i = wi - wi.dot(n) * n;
  const Vec3 r = wr - wr.dot(n) * n;
  const double phi = std::atan2(i.cross(r).norm(), i.dot(r)) / degree;
  const auto& name = table_->file.path.empty() ? table_->measurement.name : table_->file.path;
  throw NotMeasured(
      Place{name},
      fmt::format("f_r was not measured at theta_i = {:.6g}, theta_r = {:.6g}, phi = {:.6g} deg (phi = 0: retro; nor "
                  "with the directions exchanged): expected samples about there, or outside: nearest or outside: zero "
                  "in the material{}",
                  zenith(wi), zenith(wr), phi, dimension() < 3 ? fmt::format("; {}", note_of_shape(dimension())) : ""));
}

double Tabulated::lobe_error(const Direction<double>& wi, const Direction<double>& wr,
                             const Direction<double>& n) const {
  const double cos_i = wi.dot(n);
  const double cos_r = wr.dot(n);
  if (!is_above(cos_i) || !is_above(cos_r)) return 0.0;
  double moved = rounding;
  if (wi == wr) {  // the angle comes from the cosine
    const double sine = wi.cross(n).norm();
    moved += std::min(rounding_of_cosine / std::max(sine, 1e-300), std::sqrt(rounding_of_cosine));
  }
  return std::min(table_->f_r.steepness(pair_place(wi, wr, n)) * moved, largest()) * cos_i * cos_r;
}

}  // namespace lrcs
