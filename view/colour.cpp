#include "view/colour.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lrcs {
namespace {

constexpr std::array<unsigned, 10> viridis_colours{0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                                   0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};

double channel(unsigned colour, unsigned shift) {
  return ((colour >> shift) & 0xffU) / 255.0;
}

std::uint8_t byte_of(double share) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

}  // namespace

Rgb rgb_of(const Colour& colour) {
  return {byte_of(colour.red), byte_of(colour.green), byte_of(colour.blue)};
}

Colour viridis(double t) {
  if (!(t >= 0.0 && t <= 1.0)) throw std::domain_error("viridis: t lies outside [0, 1]");
  constexpr std::size_t last = viridis_colours.size() - 1;
  const double place = t * static_cast<double>(last);
  const std::size_t below = std::min(static_cast<std::size_t>(place), last - 1);
  const double share = place - static_cast<double>(below);
  const auto mixed = [&](unsigned shift) {
    return std::lerp(channel(viridis_colours[below], shift), channel(viridis_colours[below + 1], shift), share);
  };
  return {mixed(16), mixed(8), mixed(0)};
}

}  // namespace lrcs
