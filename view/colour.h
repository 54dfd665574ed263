#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace lrcs {

// An sRGB colour as shown: red, green, blue in 0..1 [1].
struct Colour {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
};

// Bytes of it, each to the nearest; what is outside 0..1 is its end.
using Rgb = std::array<std::uint8_t, 3>;
[[nodiscard]] Rgb rgb_of(const Colour& colour);

inline constexpr Colour black{0.0, 0.0, 0.0};
inline constexpr Colour white{1.0, 1.0, 1.0};
inline constexpr Colour ink{0.13, 0.13, 0.13};        // text and frames
inline constexpr Colour grid_grey{0.85, 0.85, 0.85};  // thin lines behind curves

// Colour of curve number `curve`: seven that stay apart for the colour-blind, then again from the first.
// source: M. Okabe and K. Ito, Color Universal Design, 2008 (without its yellow, too pale on white).
[[nodiscard]] constexpr Colour curve_colour(std::size_t curve) {
  constexpr std::array<Colour, 7> okabe_ito{{{0.0, 114 / 255.0, 178 / 255.0},
                                             {213 / 255.0, 94 / 255.0, 0.0},
                                             {0.0, 158 / 255.0, 115 / 255.0},
                                             {204 / 255.0, 121 / 255.0, 167 / 255.0},
                                             {0.0, 0.0, 0.0},
                                             {230 / 255.0, 159 / 255.0, 0.0},
                                             {86 / 255.0, 180 / 255.0, 233 / 255.0}}};
  return okabe_ito[curve % okabe_ito.size()];
}

// The map viridis: perceptually uniform, monotonic in lightness, safe for the colour-blind.
// domain: t in [0, 1], dark violet to yellow; outside it std::domain_error.
// error: 0.02 in each channel (ten published colours, straight lines between them).
// source: S. van der Walt and N. Smith, matplotlib 1.5, 2015 (CC0).
[[nodiscard]] Colour viridis(double t);

}  // namespace lrcs
