#include "view/svg.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "base/input_error.h"
#include "png_pixels.h"
#include "svg_reading.h"
#include "view/plot_file.h"

namespace lrcs {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

Canvas recording() {
  return {200, 100, Recording::shapes};
}

void expect_points(const std::vector<Point>& found, const std::vector<Point>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].x, expected[i].x, 6e-4) << i;
    EXPECT_NEAR(found[i].y, expected[i].y, 6e-4) << i;
  }
}

// Every kind of shape.
void draw_all(Canvas& canvas) {
  canvas.clip({{5.0, 5.0}, {150.0, 95.0}});
  canvas.fill({{10.0, 20.0}, {30.0, 50.0}}, {0.2, 0.4, 0.6}, 0.5);
  canvas.line({{1.0, 2.0}, {30.5, 40.25}, {60.0, 10.0}}, {black, 3.0, {6.0, 4.0}});
  canvas.strokes({{{0.0, 0.0}, {9.0, 9.0}}, {{20.0, 20.0}, {30.0, 20.0}}}, {ink, 1.5});
  canvas.no_clip();
  canvas.circle({60.0, 50.0}, 20.0, {black, 2.0});
  canvas.disc({90.0, 50.0}, 7.0, {1.0, 0.0, 0.0});
  canvas.area({{100.0, 10.0}, {140.0, 10.0}, {120.0, 60.0}}, {0.0, 0.0, 1.0}, 0.25);
  canvas.tiles({{{{150.0, 10.0}, {160.0, 10.0}, {155.0, 30.0}}, {0.0, 1.0, 0.0}}});
  canvas.text({20.0, 80.0}, "a < b & \"c\" > d", {.font = {20, true}, .colour = black});
  canvas.text({190.0, 50.0}, "−40 dBsm, m²", {.font = {15, false}, .x = AlignX::centre, .upward = true});
}

TEST(Svg, SaysItsSizeInPixels) {
  const Canvas canvas = recording();
  const SvgReading svg = read_back(canvas);
  EXPECT_STREQ(svg.root()->GetName(), "svg");
  EXPECT_EQ(SvgReading::attribute(svg.root(), "width"), "200");
  EXPECT_EQ(SvgReading::attribute(svg.root(), "height"), "100");
  EXPECT_EQ(SvgReading::attribute(svg.root(), "viewBox"), "0 0 200 100");
}

TEST(Svg, HoldsLinesWithTheirPointsWidthAndDashes) {
  Canvas canvas = recording();
  draw_all(canvas);
  const SvgReading svg = read_back(canvas);
  const auto lines = svg.named("path");
  ASSERT_EQ(lines.size(), 2U);
  expect_points(svg.points(lines[0]), {{1.0, 2.0}, {30.5, 40.25}, {60.0, 10.0}});
  EXPECT_EQ(SvgReading::attribute(lines[0], "stroke"), "#000000");
  EXPECT_EQ(SvgReading::attribute(lines[0], "stroke-width"), "3");
  EXPECT_EQ(SvgReading::attribute(lines[0], "stroke-dasharray"), "6 4");
  expect_points(svg.points(lines[1]), {{0.0, 0.0}, {9.0, 9.0}, {20.0, 20.0}, {30.0, 20.0}});
  EXPECT_EQ(SvgReading::attribute(svg.root(), "stroke-linejoin"), "round");
}

TEST(Svg, HoldsAreasCirclesAndTilesWithTheirColours) {
  Canvas canvas = recording();
  draw_all(canvas);
  const SvgReading svg = read_back(canvas);
  const auto box = svg.named("rect", "fill", "#336699");
  ASSERT_EQ(box.size(), 1U);
  EXPECT_EQ(SvgReading::number(box[0], "y"), 50.0);
  EXPECT_EQ(SvgReading::number(box[0], "height"), 30.0);
  EXPECT_EQ(SvgReading::number(box[0], "fill-opacity"), 0.5);
  const auto circles = svg.named("circle");
  ASSERT_EQ(circles.size(), 2U);
  EXPECT_EQ(SvgReading::number(circles[0], "r"), 20.0);
  EXPECT_EQ(SvgReading::attribute(circles[0], "fill"), "none");
  EXPECT_EQ(SvgReading::attribute(circles[1], "fill"), "#ff0000");
  const auto polygons = svg.named("polygon");
  ASSERT_EQ(polygons.size(), 2U);
  expect_points(svg.points(polygons[0]), {{100.0, 10.0}, {140.0, 10.0}, {120.0, 60.0}});
  EXPECT_EQ(SvgReading::number(polygons[0], "fill-opacity"), 0.25);
  EXPECT_EQ(SvgReading::attribute(polygons[1], "fill"), "#00ff00");
}

TEST(Svg, ClipsWhatIsDrawnBetweenClipAndNoClip) {
  Canvas canvas = recording();
  draw_all(canvas);
  const SvgReading svg = read_back(canvas);
  ASSERT_EQ(svg.named("clipPath").size(), 1U);
  vtkXMLDataElement* box = svg.named("clipPath")[0]->GetNestedElement(0);
  EXPECT_EQ(SvgReading::number(box, "x"), 5.0);
  EXPECT_EQ(SvgReading::number(box, "width"), 145.0);
  const auto groups = svg.named("g", "clip-path", "url(#clip0)");
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0]->GetNumberOfNestedElements(), 3);
  Canvas unended = recording();
  unended.clip({{5.0, 5.0}, {15.0, 15.0}});
  EXPECT_EQ(read_back(unended).named("g").size(), 1U);
}

TEST(Svg, HoldsTextsAsTheyWereGiven) {
  Canvas canvas = recording();
  draw_all(canvas);
  const SvgReading svg = read_back(canvas);
  EXPECT_EQ(svg.texts(), (std::vector<std::string>{"a < b & \"c\" > d", "−40 dBsm, m²"}));
  const auto texts = svg.named("text");
  EXPECT_EQ(SvgReading::attribute(texts[0], "font-weight"), "bold");
  EXPECT_EQ(SvgReading::number(texts[0], "y"), 20.0);
  EXPECT_EQ(SvgReading::attribute(texts[0], "text-anchor"), "start");
  EXPECT_EQ(SvgReading::attribute(texts[1], "text-anchor"), "middle");
  EXPECT_EQ(SvgReading::attribute(texts[1], "transform"), "rotate(-90 190 50)");
}

TEST(Svg, GivesTextsTheWidthThatTheyHaveInPixels) {
  for (const std::string words : {"LRCS [dBsm]", "0", "azimuth"}) {
    Canvas canvas(400, 100, Recording::shapes);
    canvas.text({20.0, 40.0}, words, {.font = {40, false}});
    const double width = SvgReading::number(read_back(canvas).named("text")[0], "textLength");
    // Ink ends somewhat before the next letter would stand.
    EXPECT_NEAR(width, text_size(words, {40, false}).width, 0.15 * 40) << words;
  }
}

TEST(Svg, PutsTheMiddleOfCapitalsWhereItWasAsked) {
  Canvas canvas = recording();
  canvas.text({20.0, 40.0}, "H", {.font = {30, false}, .y = AlignY::middle});
  const double baseline = 100.0 - SvgReading::number(read_back(canvas).named("text")[0], "y");
  EXPECT_NEAR(baseline, 40.0 - 0.5 * text_size("H", {30, false}).height, 1e-3);
}

TEST(Svg, BreaksLinesWhereAPointIsNotFinite) {
  Canvas canvas = recording();
  canvas.line({{1.0, 1.0}, {2.0, 2.0}, {no_number, 3.0}, {4.0, 4.0}, {5.0, 5.0}}, {black, 1.0});
  canvas.line({{no_number, no_number}}, {black, 1.0});
  canvas.tiles({{{{no_number, 1.0}, {2.0, 2.0}, {3.0, 1.0}}, black}});
  const SvgReading svg = read_back(canvas);
  ASSERT_EQ(svg.named("path").size(), 1U);
  EXPECT_EQ(SvgReading::attribute(svg.named("path")[0], "d"), "M1,99 2,98M4,96 5,95");
  EXPECT_EQ(svg.named("polygon").size(), 0U);
  EXPECT_EQ(canvas.svg().find("nan"), std::string::npos);
}

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6U | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> static_cast<unsigned>(bits) & 0xffU);
  }
  return bytes;
}

TEST(Svg, EmbedsPicturesPixelByPixel) {
  // Widths that leave one and two bytes over in the last group of three.
  for (const int width : {5, 6, 7}) {
    Picture picture{width, 2, {}};
    for (int k = 0; k < 6 * width; ++k) picture.rgb.push_back(static_cast<std::uint8_t>(37 * k));
    Canvas canvas = recording();
    canvas.paste(picture, 10, 20);
    const SvgReading svg = read_back(canvas);
    ASSERT_EQ(svg.named("image").size(), 1U);
    vtkXMLDataElement* image = svg.named("image")[0];
    EXPECT_EQ(SvgReading::number(image, "y"), 78.0);
    const std::string link = SvgReading::attribute(image, "xlink:href");
    const std::string head = "data:image/png;base64,";
    ASSERT_TRUE(link.starts_with(head));
    const auto png = scratch_file("embedded.png");
    std::ofstream(png, std::ios::binary) << from_base64(link.substr(head.size()));
    EXPECT_EQ(PngPixels(png).rgb, picture.rgb);
  }
}

TEST(Svg, GivesTheSameBytesTwiceAndChangesNoPixel) {
  Canvas first = recording(), second = recording(), without(200, 100);
  for (Canvas* canvas : {&first, &second, &without}) draw_all(*canvas);
  EXPECT_EQ(first.svg(), second.svg());
  EXPECT_EQ(first.picture().rgb, without.picture().rgb);
  EXPECT_THROW((void)without.svg(), std::logic_error);
}

TEST(PlotFile, IsWhatItsNameSays) {
  const auto png = scratch_file("plot.png"), svg = scratch_file("plot.svg");
  for (const auto& file : {png, svg}) {
    Canvas canvas = plot_canvas(file, 200, 100);
    draw_all(canvas);
    write_plot(file, canvas);
  }
  EXPECT_EQ(PngPixels(png).size[0], 200);
  EXPECT_EQ(SvgReading(bytes_of(svg)).texts().size(), 2U);
}

TEST(PlotFile, OfAnotherKindIsRefused) {
  const auto pdf = scratch_file("plot.pdf");
  EXPECT_THROW((void)plot_canvas(pdf, 200, 100), InputError);
  try {
    write_plot(pdf, Canvas(20, 20));
    FAIL();
  } catch (const InputError& wrong) {
    EXPECT_EQ(std::string(wrong.what()), pdf.string() + ": expected a file for a plot, that ends in .png or .svg");
  }
  EXPECT_FALSE(std::filesystem::exists(pdf));
}

TEST(Svg, KeepsLettersOfAnyScriptAndShowsBytesThatAreNoText) {
  Canvas canvas = recording();
  canvas.text({20.0, 80.0}, "panel 太阳能板 Ω", {});
  canvas.text({20.0, 30.0}, "caf\xe9\x01#2", {});
  EXPECT_EQ(read_back(canvas).texts(), (std::vector<std::string>{"panel 太阳能板 Ω", "caf<E9> #2"}));
}

}  // namespace
}  // namespace lrcs
