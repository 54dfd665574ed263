#include "view/plot_header.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "view/readable_text.h"
#include "view/shortened_text.h"

namespace lrcs {
namespace {

constexpr double margin = 28.0;         // [pixel]
constexpr double sample_length = 84.0;  // length of a line in the legend [pixel]
constexpr double text_gap = 16.0;       // between that line and its label [pixel]
constexpr double entry_gap = 48.0;      // between two entries [pixel]
constexpr double row = 48.0;            // height of a row of the legend [pixel]

double entry_width(const LegendEntry& entry, const Font& font) {
  return sample_length + text_gap + text_size(entry.label, font).width;
}

void draw_entry(Canvas& canvas, const LegendEntry& entry, const Font& font, const Point& left) {
  constexpr double half_box = 13.0;  // [pixel]
  const Point right{left.x + sample_length, left.y};
  if (entry.is_area) canvas.fill({{left.x, left.y - half_box}, {right.x, right.y + half_box}}, entry.pen.colour);
  if (!entry.is_area) canvas.line({left, right}, entry.pen);
  if (entry.marker) draw_markers(canvas, {{left.x + 0.5 * sample_length, left.y}}, *entry.marker);
  canvas.text({left.x + sample_length + text_gap, left.y}, entry.label,
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
    return fitting(entry.label, note_font, room - sample_length - text_gap);
  };
  double width = entry_gap * static_cast<double>(entries.size() - 1);
  for (const LegendEntry& entry : entries) width += entry_width(entry, font_of(entry));
  double x = 0.5 * (canvas.width() - width);
  for (const LegendEntry& entry : entries) {
    draw_entry(canvas, entry, font_of(entry), {x, y});
    x += entry_width(entry, font_of(entry)) + entry_gap;
  }
}

// As many letters as the room takes, at least one. [bytes]
std::size_t fitting_length(const std::string& word, const Font& font, double room) {
  std::vector<std::size_t> ends;  // of letters
  for (std::size_t i = 1; i <= word.size(); ++i)
    if (i == word.size() || !continues_letter(word[i])) ends.push_back(i);
  const auto fits = [&](std::size_t end) { return text_size(word.substr(0, end), font).width <= room; };
  return *(std::partition_point(ends.begin() + 1, ends.end(), fits) - 1);
}

// The word, or its pieces where it is too wide for a line.
std::vector<std::string> pieces_of(std::string word, const Font& font, double room) {
  std::vector<std::string> pieces;
  while (!word.empty()) {
    const std::size_t length = fitting_length(word, font, room);
    pieces.push_back(word.substr(0, length));
    word.erase(0, length);
  }
  return pieces;
}

// Broken where the text has line breaks, and between words where a line would be too wide.
std::vector<std::string> lines_of(const std::string& text, const Font& font, double room) {
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);) {
    std::istringstream words(readable(paragraph));
    std::string line;
    for (std::string word; words >> word;)
      for (const std::string& piece : pieces_of(word, font, room)) {
        std::string longer = line;
        longer.append(line.empty() ? "" : " ").append(piece);
        const bool fits = line.empty() || text_size(longer, font).width <= room;
        if (!fits) lines.push_back(line);
        line = fits ? longer : piece;
      }
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

// `kept` of its bytes or a few less.
std::string without_middle(const std::string& text, std::size_t kept) {
  std::size_t front = kept / 2, back = text.size() - kept / 2;
  while (front > 0 && continues_letter(text[front])) --front;
  while (back < text.size() && continues_letter(text[back])) ++back;
  return text.substr(0, front) + "..." + text.substr(back);
}

std::vector<std::string> title_lines(const std::string& title, double room) {
  constexpr std::size_t most = 2;
  std::vector<std::string> lines = lines_of(title, title_font, room);
  for (std::size_t kept = title.size(); lines.size() > most; kept -= kept / 16 + 1)
    lines = lines_of(without_middle(title, kept), title_font, room);
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
  const double room = canvas.width() - 2.0 * margin;
  // A label that is too wide in small letters, too, loses its beginning.
  const Font smallest{note_font.size / 2, note_font.bold};
  std::vector<LegendEntry> legend = header.legend;
  for (LegendEntry& entry : legend) entry.label = shortened(entry.label, smallest, room - sample_length - text_gap);
  double y = canvas.height() - margin;
  for (const std::string& line : title_lines(header.title, room)) {
    draw_centred(canvas, line, title_font, ink, y);
    y -= 1.35 * title_font.size;
  }
  for (const std::string& line : lines_of(header.note, note_font, room)) {
    draw_centred(canvas, line, note_font, note_grey, y);
    y -= 1.35 * note_font.size;
  }
  for (const auto& entries : rows_of(legend, room)) {
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
