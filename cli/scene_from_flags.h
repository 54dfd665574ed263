#pragma once
#include <string>

#include "lrcs/scene.h"

namespace CLI {
class App;
}

namespace lrcs {

// A scene said by flags instead of a scene file: one target, one material.
struct SceneFlags {
  std::string unit, material, azimuth, elevation = "0", receiver = "monostatic", wavelength;
  std::string bistatic_angle, plane = "azimuth";
  std::string forward = "+x", up = "+z", sides = "both", repair = "auto", facets = "none";

  void add_to(CLI::App& verb);
  // Was any of them given? (Then there must be no scene file.)
  [[nodiscard]] bool any() const;
};

// The scene of `lrcs sweep TARGET --unit mm --material lambert:0.8 --azimuth 0:360:1 ...`.
// error: InputError that names the flag and what was expected.
[[nodiscard]] Scene scene_from_flags(const std::string& target, const SceneFlags& flags);

// "17", "0,10,45" or "from:to:step" [deg].
[[nodiscard]] std::vector<double> angles_from_words(const std::string& words, const std::string& flag, bool is_azimuth);

}  // namespace lrcs
