#include "view/stacked_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "svg_reading.h"
#include "view/plot_header.h"

namespace lrcs {
namespace {

LayerStack three_layers() {
  return {{0.0, 10.0, 30.0}, {{"hull", {1.0, 2.0, 0.5}}, {"panel", {0.25, 0.0, 3.0}}}, {0.125, 0.5, 0.0}};
}

struct DrawnStack {
  Canvas canvas{1600, 1000, Recording::shapes};
  CartesianFrame frame;

  explicit DrawnStack(const LayerStack& stack)
      : frame(draw_stacked_plot(canvas, stack, {"Title", "a note", "azimuth [deg]"})) {}
};

TEST(StackTop, IsTheSumOfAllLayers) {
  EXPECT_EQ(stack_top(three_layers()), (std::vector<double>{1.375, 2.5, 3.5}));
  // Where plain sums lose the small layers.
  LayerStack tiny{{0.0, 1.0}, {{"large", {1e16, 1.0}}, {"one", {1.0, 1.0}}, {"another", {1.0, 1.0}}}, {}};
  EXPECT_EQ(stack_top(tiny), (std::vector<double>{1e16 + 2.0, 3.0}));
}

TEST(StackedPlot, DrawsEachLayerFromTheSumBelowToTheSumWithIt) {
  const LayerStack stack = three_layers();
  const DrawnStack drawn(stack);
  const SvgReading svg = read_back(drawn.canvas);
  const auto layers = svg.named("polygon");
  ASSERT_EQ(layers.size(), 3U);
  const std::vector<std::vector<double>> heights{{0, 0, 0}, {1, 2, 0.5}, {1.25, 2, 3.5}, {1.375, 2.5, 3.5}};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto points = svg.points(layers[k]);
    ASSERT_EQ(points.size(), 6U);
    for (std::size_t i = 0; i < 3; ++i) {
      const Point low = drawn.frame.at(stack.angle_deg[i], heights[k][i]);
      const Point high = drawn.frame.at(stack.angle_deg[i], heights[k + 1][i]);
      EXPECT_NEAR(points[i].x, low.x, 1e-3);
      EXPECT_NEAR(points[i].y, low.y, 1e-3);
      EXPECT_NEAR(points[5 - i].y, high.y, 1e-3);
    }
  }
  EXPECT_EQ(drawn.frame.y.low, 0.0);
  EXPECT_GE(drawn.frame.y.high, 3.5);
}

TEST(StackedPlot, NamesTheLayersInTheirColours) {
  const DrawnStack drawn(three_layers());
  const SvgReading svg = read_back(drawn.canvas);
  const auto texts = svg.texts();
  for (const char* words : {"Title", "a note", "azimuth [deg]", "LRCS [m²]", "hull", "panel", "others"})
    EXPECT_EQ(std::count(texts.begin(), texts.end(), words), 1) << words;
  for (vtkXMLDataElement* layer : svg.named("polygon"))
    EXPECT_EQ(svg.named("rect", "fill", SvgReading::attribute(layer, "fill")).size(), 1U);
}

TEST(StackedPlot, ShortensLongNamesFromTheLeftButTellsThemApart) {
  const std::string same = "/a-part-with-a-rather-long-name/bolt-of-the-outer-ring";
  LayerStack stack{{0.0, 1.0}, {{"assembly:1" + same, {1, 1}}, {"assembly:2" + same, {1, 1}}, {"", {1, 1}}}, {}};
  const auto texts = read_back(DrawnStack(stack).canvas).texts();
  std::vector<std::string> ends;
  for (const std::string& words : texts)
    if (words.ends_with("outer-ring")) ends.push_back(words);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_NE(ends[0], ends[1]);
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "(no name)"), 1);
  stack.layers[1].label = "plate" + std::string(200, 'x') + "é-end";
  for (const std::string& words : read_back(DrawnStack(stack).canvas).texts())
    if (words.ends_with("é-end")) {
      EXPECT_TRUE(words.starts_with("…x"));
      EXPECT_LT(text_size(words, note_font).width, 0.5 * 1600);
    }
}

TEST(StackedPlot, RefusesLayersThatCannotBe) {
  const auto refused = [](LayerStack stack) {
    Canvas canvas(1600, 1000);
    EXPECT_THROW(draw_stacked_plot(canvas, stack, {}), std::invalid_argument);
  };
  LayerStack stack = three_layers();
  stack.layers[0].sigma_m2.pop_back();
  refused(stack);
  stack = three_layers();
  stack.others_m2[1] = -1e-9;
  refused(stack);
  stack = three_layers();
  stack.layers[1].sigma_m2[0] = std::numeric_limits<double>::infinity();
  refused(stack);
  stack = three_layers();
  std::swap(stack.angle_deg[0], stack.angle_deg[1]);
  refused(stack);
  refused({{0.0}, {{"one", {1.0}}}, {}});
  stack = three_layers();
  stack.layers.resize(8, stack.layers.front());
  refused(stack);
}

}  // namespace
}  // namespace lrcs
