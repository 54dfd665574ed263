#include "view/scale_bar.h"

#include "view/colour_bar.h"
#include "view/shortened_text.h"
#include "view/ticks.h"

namespace lrcs {
namespace {

void draw_names(Canvas& canvas, const Box& bar, double room, const ColourScale& scale, const Font& font) {
  const double side = 1.2 * font.size, left = bar.low.x - 1.8 * font.size;
  double top = bar.high.y;
  canvas.text({left, top}, scale.title, {.font = {font.size, true}, .y = AlignY::top});
  std::vector<std::string> names;
  for (const auto& [name, colour] : scale.names) names.push_back(name.empty() ? "(no name)" : name);
  const ShortenedTexts shown = shortened_apart(names, font, room - 1.6 * font.size);
  for (std::size_t k = 0; k < names.size(); ++k) {
    top -= 1.8 * font.size;
    const Box patch{{left, top - side}, {left + side, top}};
    canvas.fill(patch, scale.names[k].second);
    canvas.frame(patch, {ink, 1.0});
    canvas.text({patch.high.x + 0.4 * font.size, top - 0.5 * side}, shown.texts[k],
                {.font = shown.font, .y = AlignY::middle});
  }
}

// Both limits, whatever they are, and round values between that stand clear of them.
void draw_marks(Canvas& canvas, const Box& bar, double room, const ColourScale& scale, const Font& font) {
  const double span = scale.high - scale.low, height = bar.high.y - bar.low.y;
  const double step = scale.is_angle ? angle_step(span, 6) : nice_step(span, 6);
  const double tick = 0.35 * font.size, clear = 1.3 * font.size * span / height;
  const double right = bar.low.x - 1.8 * font.size + room;
  const auto draw_mark = [&](double mark, const std::string& label) {
    const double y = bar.low.y + height * (mark - scale.low) / span, x = bar.high.x + 1.8 * tick;
    canvas.line({{bar.high.x, y}, {bar.high.x + tick, y}}, {ink, 0.08 * font.size});
    canvas.text({x, y}, label, {.font = fitting(label, font, right - x), .y = AlignY::middle});
  };
  constexpr int digits = 4;
  for (const double mark : multiples(scale.low + clear, scale.high - clear, step))
    draw_mark(mark, number_label(mark, digits));
  draw_mark(scale.high, number_label(scale.high, digits));
  draw_mark(scale.low, (scale.is_open_below ? "≤ " : "") + number_label(scale.low, digits));
}

}  // namespace

void draw_scale(Canvas& canvas, const Box& bar, double room, const ColourScale& scale, const Font& font) {
  if (scale.names.empty() && scale.low == scale.high) {
    canvas.text({bar.low.x, bar.low.y}, scale.title, {.font = font});
  } else if (scale.names.empty()) {
    draw_viridis(canvas, bar);
    canvas.frame(bar, {ink, 0.08 * font.size});
    draw_marks(canvas, bar, room, scale, font);
    canvas.text({bar.low.x - 0.6 * font.size, 0.5 * (bar.low.y + bar.high.y)}, scale.title,
                {.font = fitting(scale.title, font, bar.high.y - bar.low.y), .x = AlignX::centre, .upward = true});
  } else {
    draw_names(canvas, bar, room, scale, font);
  }
  if (!scale.has_unseen) return;
  const Box grey{{bar.low.x, bar.low.y - 2.2 * font.size}, {bar.high.x, bar.low.y - 1.2 * font.size}};
  canvas.fill(grey, unseen_grey);
  canvas.frame(grey, {ink, 0.08 * font.size});
  canvas.text({grey.high.x + 0.6 * font.size, 0.5 * (grey.low.y + grey.high.y)}, "unseen",
              {.font = font, .y = AlignY::middle});
}

}  // namespace lrcs
