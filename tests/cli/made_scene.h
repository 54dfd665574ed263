#pragma once
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "tests/cli/program.h"

namespace lrcs {

using Point = std::array<double, 3>;

inline std::string stl_facet(const Point& a, const Point& b, const Point& c) {
  std::string text = "facet normal 0 0 0\nouter loop\n";
  for (const Point& p : {a, b, c}) {
    std::array<char, 100> line{};
    std::snprintf(line.data(), line.size(), "vertex %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    text += line.data();
  }
  return text + "endloop\nendfacet\n";
}

inline std::string stl_box(const std::string& name, const Point& low, const Point& high) {
  constexpr std::array<std::array<int, 3>, 12> facets{{{0, 2, 1},
                                                       {1, 2, 3},
                                                       {4, 5, 6},
                                                       {5, 7, 6},
                                                       {0, 1, 4},
                                                       {1, 5, 4},
                                                       {2, 6, 3},
                                                       {3, 6, 7},
                                                       {0, 4, 2},
                                                       {2, 4, 6},
                                                       {1, 3, 5},
                                                       {3, 7, 5}}};
  const auto corner = [&](int k) -> Point {
    return {(k & 1) != 0 ? high[0] : low[0], (k & 2) != 0 ? high[1] : low[1], (k & 4) != 0 ? high[2] : low[2]};
  };
  std::string text = "solid " + name + "\n";
  for (const auto& f : facets) text += stl_facet(corner(f[0]), corner(f[1]), corner(f[2]));
  return text + "endsolid " + name + "\n";
}

// A body and a panel that partly hides it: 24 facets in two parts.
inline std::string two_boxes() {
  return stl_box("body", {-1, -0.5, -0.5}, {1, 0.5, 0.5}) + stl_box("panel1", {-0.2, 0.6, -0.1}, {0.2, 2, 0.1});
}

// A sphere of radius 1 m, 4 n (n - 1) facets.
inline std::string stl_sphere(int n) {
  const auto at = [n](int ring, int sector) -> Point {
    const double t = std::numbers::pi * ring / n, p = std::numbers::pi * sector / n;
    if (ring == 0 || ring == n) return {0.0, 0.0, ring == 0 ? -1.0 : 1.0};
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), -std::cos(t)};
  };
  std::string text = "solid ball\n";
  for (int r = 0; r < n; ++r)
    for (int s = 0; s < 2 * n; ++s) {
      const int next = (s + 1) % (2 * n);
      if (r > 0) text += stl_facet(at(r, s), at(r, next), at(r + 1, next));
      if (r + 1 < n) text += stl_facet(at(r, s), at(r + 1, next), at(r + 1, s));
    }
  return text + "endsolid ball\n";
}

// The scene of the two boxes: 14 lines, 5 directions.
inline const std::string good_scene = R"(lrcs: 1
wavelength: 1.06 um
target:
  file: box.stl
  unit: m
materials:
  skin: {library: metal-skin-5p}
  white: {model: lambert, reflectance: 0.8}
assign:
  - {part: "panel*", material: skin}
  - {default: white}
sweep:
  azimuth: {from: 0, to: 40, step: 10}
  elevation: 0
)";

// good_scene with one piece of its text replaced.
inline std::string scene_with(const std::string& piece, const std::string& other) {
  std::string text = good_scene;
  return text.replace(text.find(piece), piece.size(), other);
}

}  // namespace lrcs
