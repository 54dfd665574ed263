#include "brdf/brdf_form.h"

#include <algorithm>
#include <cassert>

namespace lrcs {
namespace {

Brdf make_lambert(const std::vector<double>& values, int /*azimuth_of_specular*/) {
  return Lambert(values.at(0));
}

WuParameters<double> five(const std::vector<double>& values, int azimuth_of_specular) {
  WuParameters<double> p;
  p.kb = values.at(0);
  p.kr = values.at(1);
  p.b = values.at(2);
  p.a = values.at(3);
  p.kd = values.at(4);
  p.azimuth_of_specular = azimuth_of_specular;
  return p;
}

Brdf make_five(const std::vector<double>& values, int azimuth_of_specular) {
  return Wu(five(values, azimuth_of_specular));
}

Brdf make_nine(const std::vector<double>& values, int azimuth_of_specular) {
  WuParameters<double> p = five(values, azimuth_of_specular);
  p.sigma_p = values.at(5);
  p.sigma_r = values.at(6);
  p.u_p = values.at(7);
  p.v_p = values.at(8);
  return Wu(p);
}

BrdfWords words(const Lambert& model) {
  return {find_brdf_form("lambert"), {model.reflectance()}};
}

BrdfWords words(const Wu& model) {
  const auto& p = model.parameters();
  std::vector<double> values{p.kb, p.kr, p.b, p.a, p.kd};
  if (p.has_empirical_shadowing()) return {find_brdf_form("five_parameter"), values, p.azimuth_of_specular};
  values.insert(values.end(), {p.sigma_p, p.sigma_r, p.u_p, p.v_p});
  return {find_brdf_form("nine_parameter"), values, p.azimuth_of_specular};
}

}  // namespace

const std::vector<BrdfForm>& brdf_forms() {
  static const std::vector<BrdfForm> forms{
      {"lambert", "ideally diffuse", {"reflectance"}, false, make_lambert},
      {"five_parameter", "Wu 2002, empirical shadowing", {"kb", "kr", "b", "a", "kd"}, true, make_five},
      {"nine_parameter",
       "Wu 2002, fitted shadowing",
       {"kb", "kr", "b", "a", "kd", "sigma_p", "sigma_r", "u_p", "v_p"},
       true,
       make_nine}};
  return forms;
}

const BrdfForm* find_brdf_form(std::string_view name) {
  const auto& forms = brdf_forms();
  const auto found = std::find_if(forms.begin(), forms.end(), [&](const BrdfForm& form) { return form.name == name; });
  return found == forms.end() ? nullptr : &*found;
}

BrdfWords words_of(const Brdf& brdf) {
  return std::visit([](const auto& model) { return words(model); }, brdf);
}

}  // namespace lrcs
