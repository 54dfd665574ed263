#include "view/plot_header.h"

#include <array>
#include <sstream>

namespace lrcs {
namespace {

constexpr double margin = 28.0;     // [pixel]
constexpr double stroke = 84.0;     // length of a line in the legend [pixel]
constexpr double text_gap = 16.0;   // between that line and its label [pixel]
constexpr double entry_gap = 48.0;  // between two entries [pixel]
constexpr double row = 48.0;        // height of a row of the legend [pixel]

double entry_width(const LegendEntry& entry, const Font& font) {
  return stroke + text_gap + text_size(entry.label, font).width;
}

void draw_entry(Canvas& canvas, const LegendEntry& entry, const Font& font, const Point& left) {
  canvas.line({left, {left.x + stroke, left.y}}, entry.pen);
  if (entry.marker) draw_markers(canvas, {{left.x + 0.5 * stroke, left.y}}, *entry.marker);
  canvas.text({left.x + stroke + text_gap, left.y}, entry.label,
              {.font = font, .x = AlignX::left, .y = AlignY::middle});
}

// Rows of entries, each as full as the room allows.
std::vector<std::vector<LegendEntry>> rows_of(const std::vector<LegendEntry>& legend, double room) {
  std::vector<std::vector<LegendEntry>> rows;
  double taken = 0.0;
  for (const LegendEntry& entry : legend) {
    const double width = entry_width(entry, note_font);
    if (rows.empty() || entry.starts_row || taken + entry_gap + width > room) {
      rows.emplace_back();
      taken = -entry_gap;
    }
    rows.back().push_back(entry);
    taken += entry_gap + width;
  }
  return rows;
}

void draw_row(Canvas& canvas, const std::vector<LegendEntry>& entries, double y) {
  const double room = canvas.width() - 2.0 * margin;
  const auto font_of = [&](const LegendEntry& entry) {
    return fitting(entry.label, note_font, room - stroke - text_gap);
  };
  double width = entry_gap * static_cast<double>(entries.size() - 1);
  for (const LegendEntry& entry : entries) width += entry_width(entry, font_of(entry));
  double x = 0.5 * (canvas.width() - width);
  for (const LegendEntry& entry : entries) {
    draw_entry(canvas, entry, font_of(entry), {x, y});
    x += entry_width(entry, font_of(entry)) + entry_gap;
  }
}

// Broken where the text has line breaks, and between words where a line would be too wide.
std::vector<std::string> lines_of(const std::string& text, const Font& font, double room) {
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);) {
    std::istringstream words(paragraph);
    std::string line;
    for (std::string word; words >> word;) {
      std::string longer = line;
      longer.append(line.empty() ? "" : " ").append(word);
      const bool fits = line.empty() || text_size(longer, font).width <= room;
      if (!fits) lines.push_back(line);
      line = fits ? longer : word;
    }
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

void draw_centred(Canvas& canvas, const std::string& text, const Font& font, const Colour& colour, double top) {
  const Font fitted = fitting(text, font, canvas.width() - 2.0 * margin);
  canvas.text({0.5 * canvas.width(), top}, text,
              {.font = fitted, .colour = colour, .x = AlignX::centre, .y = AlignY::top});
}

}  // namespace

double draw_header(Canvas& canvas, const PlotHeader& header) {
  constexpr Colour note_grey{0.35, 0.35, 0.35};
  double y = canvas.height() - margin;
  if (!header.title.empty()) {
    draw_centred(canvas, header.title, title_font, ink, y);
    y -= 1.35 * title_font.size;
  }
  for (const std::string& line : lines_of(header.note, note_font, canvas.width() - 2.0 * margin)) {
    draw_centred(canvas, line, note_font, note_grey, y);
    y -= 1.35 * note_font.size;
  }
  for (const auto& entries : rows_of(header.legend, canvas.width() - 2.0 * margin)) {
    draw_row(canvas, entries, y - 0.5 * row);
    y -= row;
  }
  return y - 0.5 * margin;
}

Pen curve_pen(std::size_t curve) {
  constexpr std::size_t colours = 7;
  static const std::array<std::vector<double>, 3> dashes{{{}, {18.0, 12.0}, {4.0, 10.0}}};
  return {curve_colour(curve), 5.0, dashes[(curve / colours) % dashes.size()]};
}

}  // namespace lrcs
