#include "view/shortened_text.h"

#include "view/readable_text.h"

namespace lrcs {

std::string shortened(const std::string& name, const Font& font, double room) {
  const std::string text = readable(name);
  if (text_size(text, font).width <= room) return text;
  const auto end_from = [&](std::size_t from) {
    while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xc0U) == 0x80U) ++from;
    return "…" + text.substr(from);
  };
  std::size_t low = 0, high = text.size();  // too long from the one on, not from the other
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (text_size(end_from(middle), font).width <= room ? high : low) = middle;
  }
  return end_from(high);
}

}  // namespace lrcs
