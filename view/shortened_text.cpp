#include "view/shortened_text.h"

#include <cmath>
#include <set>

#include "view/readable_text.h"

namespace lrcs {
namespace {

enum class Kept { end, beginning };

std::string cut_to(const std::string& text, const Font& font, double room, Kept kept) {
  std::string shown = readable(text);
  if (text_size(shown, font).width <= room) return shown;
  // Without at least so many bytes.
  const auto without = [&](std::size_t bytes) {
    if (kept == Kept::end) {
      while (bytes < shown.size() && continues_letter(shown[bytes])) ++bytes;
      return "…" + shown.substr(bytes);
    }
    std::size_t left = shown.size() - bytes;
    while (left > 0 && continues_letter(shown[left])) --left;
    return shown.substr(0, left) + "…";
  };
  std::size_t low = 0, high = shown.size();  // too long without the one, not without the other
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (text_size(without(middle), font).width <= room ? high : low) = middle;
  }
  return without(high);
}

// "…y:1/…y:3/bolt": of each step of a path but the last one as many of its last letters as there is room for.
std::string with_short_steps(const std::string& text, const Font& font, double room) {
  const std::string whole = readable(text);
  std::string shown = whole;
  for (std::size_t kept = 12; kept >= 2 && text_size(shown, font).width > room; --kept) {
    shown.clear();
    std::size_t begin = 0;
    for (std::size_t end = whole.find('/'); end != std::string::npos; end = whole.find('/', begin)) {
      std::size_t from = end - begin > kept + 1 ? end - kept : begin;
      while (continues_letter(whole[from])) ++from;
      shown += (from > begin ? "…" : "") + whole.substr(from, end + 1 - from);
      begin = end + 1;
    }
    shown += whole.substr(begin);
  }
  shown = cut_to(shown, font, room, Kept::end);
  const std::string dots = "…";
  return shown.starts_with(dots + dots) ? shown.substr(dots.size()) : shown;
}

std::size_t different(const std::vector<std::string>& texts) {
  return std::set<std::string>(texts.begin(), texts.end()).size();
}

}  // namespace

std::string shortened(const std::string& text, const Font& font, double room) {
  return cut_to(text, font, room, Kept::end);
}

ShortenedTexts shortened_apart(const std::vector<std::string>& texts, const Font& font, double room) {
  using Way = std::string (*)(const std::string&, const Font&, double);
  const auto first_letters = [](const std::string& text, const Font& smaller, double of) {
    return cut_to(text, smaller, of, Kept::beginning);
  };
  const auto cut = [&](const Font& smaller, Way way) {
    std::vector<std::string> shown;
    shown.reserve(texts.size());
    for (const std::string& text : texts) shown.push_back(way(text, smaller, room));
    return shown;
  };
  const std::size_t wanted = different(texts);
  for (const double size : {1.0, 0.9, 0.8, 0.7, 0.6}) {
    const Font smaller{static_cast<int>(std::lround(size * font.size)), font.bold};
    for (const Way way : {Way{shortened}, Way{with_short_steps}, Way{first_letters}})
      if (auto shown = cut(smaller, way); different(shown) == wanted) return {std::move(shown), smaller};
  }
  return {cut(font, shortened), font};
}

}  // namespace lrcs
