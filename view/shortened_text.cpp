#include "view/shortened_text.h"

#include "view/readable_text.h"

namespace lrcs {

std::string shortened(const std::string& text, const Font& font, double room) {
  std::string shown = readable(text);
  if (text_size(shown, font).width <= room) return shown;
  const auto end_from = [&](std::size_t from) {
    while (from < shown.size() && continues_letter(shown[from])) ++from;
    return "…" + shown.substr(from);
  };
  std::size_t low = 0, high = shown.size();  // too long from the one on, not from the other
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (text_size(end_from(middle), font).width <= room ? high : low) = middle;
  }
  return end_from(high);
}

}  // namespace lrcs
