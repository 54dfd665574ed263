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
  for (const auto& [name, colour] : scale.names) {
    top -= 1.8 * font.size;
    const Box patch{{left, top - side}, {left + side, top}};
    canvas.fill(patch, colour);
    canvas.frame(patch, {ink, 1.0});
    const std::string text = name.empty() ? "(no name)" : name;
    canvas.text({patch.high.x + 0.4 * font.size, top - 0.5 * side}, shortened(text, font, room - 1.6 * font.size),
                {.font = font, .y = AlignY::middle});
  }
}

void draw_marks(Canvas& canvas, const Box& bar, const ColourScale& scale, const Font& font) {
  const double span = scale.high - scale.low, height = bar.high.y - bar.low.y;
  const double step = span > 45.0 ? angle_step(span, 6) : nice_step(span, 6);
  const double tick = 0.35 * font.size;
  for (const double mark : multiples(scale.low, scale.high, step)) {
    const double y = bar.low.y + height * (mark - scale.low) / span;
    canvas.line({{bar.high.x, y}, {bar.high.x + tick, y}}, {ink, 0.08 * font.size});
    const bool is_lowest = mark - scale.low < 0.5 * step;
    const std::string label = (scale.is_open_below && is_lowest ? "≤ " : "") + tick_label(mark, step);
    canvas.text({bar.high.x + 1.8 * tick, y}, label, {.font = font, .y = AlignY::middle});
  }
}

}  // namespace

void draw_scale(Canvas& canvas, const Box& bar, double room, const ColourScale& scale, const Font& font) {
  if (scale.names.empty()) {
    draw_viridis(canvas, bar);
    canvas.frame(bar, {ink, 0.08 * font.size});
    draw_marks(canvas, bar, scale, font);
    canvas.text({bar.low.x - 0.6 * font.size, 0.5 * (bar.low.y + bar.high.y)}, scale.title,
                {.font = fitting(scale.title, font, bar.high.y - bar.low.y), .x = AlignX::centre, .upward = true});
    if (!scale.note.empty())
      canvas.text({bar.low.x - 1.8 * font.size, bar.high.y + 0.8 * font.size}, scale.note,
                  {.font = fitting(scale.note, font, room)});
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
