#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>

#include "brdf/cook_torrance.h"
#include "brdf/lambert.h"
#include "brdf/phong.h"
#include "brdf/steinvall.h"
#include "brdf/wu.h"

namespace lrcs {

// One parameter of a form.
struct FormParameter {
  std::string_view name;     // its key in a scene file
  std::string_view meaning;  // in words, with the unit
  double least, most;        // a fit keeps to [least, most], within the model's domain
  double from, to;           // where a search begins to look; of no effect for linear parameters
  enum class Scale { linear, logarithmic, ratio } scale = Scale::linear;  // in which such a range is even
  bool is_linear = false;  // f_r is linear in these parameters together, the others being given
};

// The forms: every way to write a model down, as types. `model: name` in a scene file. A model may have several.
//   title          in a picture
//   parameters     in the order of the values
//   make<T>(values, azimuth_of_specular)   the model on that scalar; ParameterError outside its domain
//   values(model)  the inverse of make, on doubles
// Readers, writers, the fitter, the tables and the law tests go by this list: brdf/brdf_form.h has it at run time.
namespace forms {

using enum FormParameter::Scale;
template <class T, std::size_t N>
using Values = std::array<T, N>;

constexpr FormParameter linear_parameter(std::string_view name, std::string_view meaning, double most) {
  return {name, meaning, 0.0, most, 0.0, 1.0, linear, true};
}

struct LambertForm {
  static constexpr std::string_view name = "lambert", title = "Lambert", description = "ideally diffuse";
  static constexpr bool has_azimuth_of_specular = false;
  static constexpr std::array parameters{linear_parameter("reflectance", "albedo [1]", 1.0)};
  template <class T>
  static LambertModel<T> make(const Values<T, 1>& v, int /*azimuth_of_specular*/) {
    return LambertModel<T>(v[0]);
  }
  static Values<double, 1> values(const Lambert& model) { return {model.reflectance()}; }
};

inline constexpr std::array wu_parameters{
    linear_parameter("kb", "height of the lobe [1/sr]", 1e10),
    FormParameter{"kr", "breadth of the lobe [1]", 1e-3, 1e3, 0.03, 10.0, ratio},
    FormParameter{"b", "fall of the reflectance with gamma [1]", -1e4, 300.0, -100.0, 20.0, linear},
    FormParameter{"a", "power of that fall [1]", 0.02, 50.0, 0.2, 5.0, ratio},
    linear_parameter("kd", "height of the diffuse term [1/sr]", 1e10),
    FormParameter{"sigma_p", "shadowing at normal incidence [1]", 0.0, 1e4, 1e-3, 10.0, ratio},
    FormParameter{"sigma_r", "shadowing off the plane of incidence [1]", 0.0, 1e4, 0.01, 100.0, ratio},
    FormParameter{"u_p", "growth of the shadowing with alpha [1]", 0.0, 1e6, 0.1, 100.0, ratio},
    FormParameter{"v_p", "delay of that growth [1]", 1e-4, 1e4, 0.05, 50.0, ratio}};

struct FiveParameterForm {
  static constexpr std::string_view name = "five_parameter", title = "five parameters",
                                    description = "Wu 2002, empirical shadowing";
  static constexpr bool has_azimuth_of_specular = true;
  static constexpr std::array parameters{wu_parameters[0], wu_parameters[1], wu_parameters[2], wu_parameters[3],
                                         wu_parameters[4]};
  template <class T>
  static WuModel<T> make(const Values<T, 5>& v, int azimuth_of_specular) {
    WuParameters<T> p{.kb = v[0], .kr = v[1], .b = v[2], .a = v[3], .kd = v[4]};
    p.azimuth_of_specular = azimuth_of_specular;
    return WuModel<T>(p);
  }
  static Values<double, 5> values(const Wu& model) {
    const auto& p = model.parameters();
    return {p.kb, p.kr, p.b, p.a, p.kd};
  }
};

struct NineParameterForm {
  static constexpr std::string_view name = "nine_parameter", title = "nine parameters",
                                    description = "Wu 2002, fitted shadowing";
  static constexpr bool has_azimuth_of_specular = true;
  static constexpr std::array parameters = wu_parameters;
  template <class T>
  static WuModel<T> make(const Values<T, 9>& v, int azimuth_of_specular) {
    return WuModel<T>({v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], azimuth_of_specular});
  }
  static Values<double, 9> values(const Wu& model) {
    const auto& p = model.parameters();
    return {p.kb, p.kr, p.b, p.a, p.kd, p.sigma_p, p.sigma_r, p.u_p, p.v_p};
  }
};

struct SteinvallForm {
  static constexpr std::string_view name = "steinvall", title = "Steinvall",
                                    description = "Steinvall 2000, lobe and cosine power";
  static constexpr bool has_azimuth_of_specular = false;
  static constexpr std::array parameters{
      linear_parameter("A", "height of the lobe [1/sr]", 1e10),
      linear_parameter("B", "height of the diffuse term [1/sr]", 1e10),
      FormParameter{"s", "root mean square slope times sqrt 2 [1]", 1e-5, 20.0, 0.01, 2.0, logarithmic},
      FormParameter{"m", "power of the diffuse term [1]", 0.0, 1e3, 0.0, 10.0, linear}};
  template <class T>
  static SteinvallModel<T> make(const Values<T, 4>& v, int /*azimuth_of_specular*/) {
    return SteinvallModel<T>(v[0], v[1], v[2], v[3]);
  }
  static Values<double, 4> values(const Steinvall& model) { return {model.A(), model.B(), model.s(), model.m()}; }
};

struct PhongForm {
  static constexpr std::string_view name = "phong", title = "Phong",
                                    description = "Phong 1975, cosine power about specular";
  static constexpr bool has_azimuth_of_specular = false;
  static constexpr std::array parameters{linear_parameter("kd", "diffuse albedo [1]", 1e10),
                                         linear_parameter("ks", "albedo of the lobe [1]", 1e10),
                                         FormParameter{"m", "power of the lobe [1]", 1.0, 1e8, 1.0, 1e5, logarithmic}};
  template <class T>
  static PhongModel<T> make(const Values<T, 3>& v, int /*azimuth_of_specular*/) {
    return PhongModel<T>(v[0], v[1], v[2]);
  }
  static Values<double, 3> values(const Phong& model) { return {model.kd(), model.ks(), model.m()}; }
};

inline constexpr std::array mirror_parameters{
    linear_parameter("kd", "diffuse albedo [1]", 1e10),
    linear_parameter("ks", "share of the surface that mirrors [1]", 1e10),
    FormParameter{"f0", "reflectance of a mirror at normal incidence [1]", 0.0, 1.0, 0.0, 1.0, linear},
    FormParameter{"roughness", "breadth of the slopes [1]", 1e-5, 20.0, 0.01, 2.0, logarithmic}};

template <class Slopes>
struct CookTorranceForm {
  static constexpr bool has_azimuth_of_specular = false;
  static constexpr std::array parameters = mirror_parameters;
  template <class T>
  static CookTorranceModel<T, Slopes> make(const Values<T, 4>& v, int /*azimuth_of_specular*/) {
    return CookTorranceModel<T, Slopes>(v[0], v[1], v[2], v[3]);
  }
  static Values<double, 4> values(const CookTorranceModel<double, Slopes>& model) {
    return {model.kd(), model.ks(), model.f0(), model.roughness()};
  }
};

struct CookTorranceBeckmannForm : CookTorranceForm<Beckmann> {
  static constexpr std::string_view name = "cook_torrance_beckmann", title = "Cook-Torrance, Beckmann",
                                    description = "Cook and Torrance 1982, Gaussian slopes";
};

struct CookTorranceGgxForm : CookTorranceForm<Ggx> {
  static constexpr std::string_view name = "cook_torrance_ggx", title = "Cook-Torrance, GGX",
                                    description = "Cook and Torrance 1982, GGX slopes";
};

}  // namespace forms

using FormList =
    std::tuple<forms::LambertForm, forms::FiveParameterForm, forms::NineParameterForm, forms::SteinvallForm,
               forms::PhongForm, forms::CookTorranceBeckmannForm, forms::CookTorranceGgxForm>;

}  // namespace lrcs
