#pragma once
#include <string>
#include <vector>

#include "lrcs/scene.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lrcs {

// A scene said by flags instead of a scene file: one target, one material.
struct SceneFlags {
  std::string unit, material, azimuth, elevation = "0", receiver = "monostatic", wavelength;
  std::string bistatic_angle, plane = "azimuth", chord_tolerance, chord_angle;
  std::string forward, up, sides = "both", repair = "auto", curved = "auto", facets = "none";
  std::vector<const CLI::Option*> options;  // set by add_to

  void add_to(CLI::App& verb);
  [[nodiscard]] bool given(const std::string& flag) const;
  // The first flag that the user gave, or "". (Beside a scene file there must be none.)
  [[nodiscard]] std::string first_given() const;
};

// The scene of `lrcs sweep TARGET --unit mm --material lambert:0.8 --azimuth 0:360:1 ...`.
// error: InputError that names the flag and what was expected.
[[nodiscard]] Scene scene_from_flags(const std::string& target, const SceneFlags& flags);

}  // namespace lrcs
