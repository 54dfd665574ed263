#include "brdf/brdf_form.h"

#include <algorithm>

namespace lrcs {
namespace {

template <class Form>
Brdf make(const std::vector<double>& values, int azimuth_of_specular) {
  forms::Values<double, Form::parameters.size()> v{};
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = values.at(k);
  return Form::template make<double>(v, azimuth_of_specular);
}

template <class Form>
BrdfForm form() {
  BrdfForm form{std::string(Form::name),        std::string(Form::title),
                std::string(Form::description), {},
                Form::has_azimuth_of_specular,  make<Form>};
  for (const FormParameter& p : Form::parameters) form.parameters.emplace_back(p.name);
  return form;
}

template <class... Forms>
std::vector<BrdfForm> forms_of(const std::tuple<Forms...>* /*list*/) {
  return {form<Forms>()...};
}

template <class Form, class Model>
BrdfWords words_in(const Model& model) {
  const auto values = Form::values(model);
  return {find_brdf_form(Form::name), {values.begin(), values.end()}};
}

BrdfWords words(const Lambert& model) {
  return words_in<forms::LambertForm>(model);
}
BrdfWords words(const Wu& model) {
  BrdfWords words = model.parameters().has_empirical_shadowing() ? words_in<forms::FiveParameterForm>(model)
                                                                 : words_in<forms::NineParameterForm>(model);
  words.azimuth_of_specular = model.parameters().azimuth_of_specular;
  return words;
}
BrdfWords words(const Steinvall& model) {
  return words_in<forms::SteinvallForm>(model);
}
BrdfWords words(const Phong& model) {
  return words_in<forms::PhongForm>(model);
}
BrdfWords words(const CookTorranceBeckmann& model) {
  return words_in<forms::CookTorranceBeckmannForm>(model);
}
BrdfWords words(const CookTorranceGgx& model) {
  return words_in<forms::CookTorranceGgxForm>(model);
}
BrdfWords words(const Tabulated& /*model*/) {
  return {};
}

}  // namespace

const std::vector<BrdfForm>& brdf_forms() {
  static const std::vector<BrdfForm> forms = forms_of(static_cast<const FormList*>(nullptr));
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
