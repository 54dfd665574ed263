#include "measurement/convention.h"

#include <fmt/format.h>

#include <string_view>

namespace lrcs {
namespace {

constexpr int default_azimuth = 180;

std::string azimuth_text(int deg) {
  return fmt::format("azimuth of specular: {} deg", deg);
}

std::string value_text(bool has_cosine) {
  return has_cosine ? "value: f_r cos theta_r, divided by the cosine" : "value: f_r";
}

// Takes the answer from the file, the options or the default, and says from which.
template <class T, class Text>
T answer(const std::optional<Said<T>>& said, std::optional<T> asked, T otherwise, const Text& text, std::string& note) {
  if (said && asked && said->value != *asked)
    throw InputError(said->place, fmt::format("the file says {}, asked for was {}", text(said->value), text(*asked)));
  const T value = said ? said->value : asked.value_or(otherwise);
  note = fmt::format("{} ({})", text(value), said ? "the file says so" : asked ? "asked for" : "the file says nothing");
  return value;
}

}  // namespace

void Convention::apply(MeasurementBuilder& builder) const {
  builder.set_value_has_cosine(value_has_cosine);
  builder.note(azimuth_note);
  builder.note(value_note);
}

Convention settled(const SaidConvention& said, const MeasurementOptions& options) {
  Convention convention;
  convention.azimuth_of_specular = answer(said.azimuth_of_specular, options.azimuth_of_specular, default_azimuth,
                                          azimuth_text, convention.azimuth_note);
  convention.value_has_cosine =
      answer(said.value_has_cosine, options.value_has_cosine, false, value_text, convention.value_note);
  return convention;
}

Convention fixed(int azimuth_of_specular, bool value_has_cosine, const Place& place,
                 const MeasurementOptions& options) {
  return settled({Said<int>{azimuth_of_specular, place}, Said<bool>{value_has_cosine, place}}, options);
}

}  // namespace lrcs
