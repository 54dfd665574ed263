#include "view/aspect_view.h"

#include <gtest/gtest.h>

#include <set>

#include "two_plates.h"
#include "view/part_returns.h"
#include "view/shortened_text.h"

namespace lrcs {
namespace {

// A long rod along y, in two parts, seen from x: 2000 times as long as thick.
FacetMesh rod() {
  FacetMesh mesh;
  mesh.part.names = {"left", "right"};
  for (const std::uint32_t part : {0U, 1U}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const double y : {-1.0 * part, 1.0 - part})
      for (const double z : {-0.01, 0.01}) mesh.positions.emplace_back(0.0, y, z);
    mesh.facets.push_back({first, first + 2, first + 3});
    mesh.facets.push_back({first, first + 3, first + 1});
    mesh.part.of.insert(mesh.part.of.end(), {part, part});
    mesh.source_facet.insert(mesh.source_facet.end(), {2 * part, 2 * part + 1});
  }
  measure_facets(mesh);
  return mesh;
}

FacetResult result_of(const FacetMesh& mesh, std::size_t row) {
  FacetResult result;
  result.material.assign(mesh.size(), 0);
  result.material_names = {"white"};
  result.seen_fraction.assign(mesh.size(), 1.0);
  for (std::size_t k = 0; k < mesh.size(); ++k) result.sigma_m2.push_back(static_cast<double>((row + 1) * (k + 1)));
  for (const double sigma : result.sigma_m2) result.sigma_total_m2 += sigma;
  return result;
}

ViewedSweep sweep_of(const FacetMesh& mesh) {
  ViewedSweep sweep{&mesh, "a rod", {"", "azimuth [deg]", CutAngle::azimuth}, {}, {}, {}, {}};
  sweep.cuts.push_back({{"", {0.0, 10.0}, {10.0, 20.0}}, {0, 1}});
  sweep.places = {{0, 0}, {0, 1}};
  sweep.sigma_m2 = {10.0, 20.0};
  sweep.bound_m2 = {0.0, 0.0};
  return sweep;
}

bool is_white(const Picture& picture, int column, int row) {
  const auto* pixel = &picture.rgb[3 * static_cast<std::size_t>(row * picture.width + column)];
  return pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
}

TEST(AspectView, ShowsAllOfATargetHoweverTheRoomIsShaped) {
  const FacetMesh mesh = rod();
  const ViewedSweep sweep = sweep_of(mesh);
  AspectView view(sweep, [&](std::size_t row) { return result_of(mesh, row); });
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{640, 1200}, {1600, 400}, {1000, 800}}) {
    const Picture picture = view.picture(width, height);
    const Box box = view.sheet().target();
    int inked = 0;
    const auto top = static_cast<int>(box.high.y) - 1, right = static_cast<int>(box.high.x) - 1;
    for (int row = static_cast<int>(box.low.y) + height / 4; row < top; ++row) {
      EXPECT_TRUE(is_white(picture, 1, row)) << width << " " << row;
      EXPECT_TRUE(is_white(picture, right, row)) << width << " " << row;
      for (int column = 0; column < right; ++column) inked += is_white(picture, column, row) ? 0 : 1;
    }
    EXPECT_GT(inked, width) << width;
  }
}

// Heights of the lines of letters in the upper left, from the top [pixel].
std::vector<int> line_heights(const Picture& picture) {
  std::vector<int> heights;
  bool inside = false;
  for (int row = picture.height - 1; row > picture.height - picture.width / 10; --row) {
    bool inked = false;
    for (int column = 0; column < picture.width / 3; ++column) inked |= !is_white(picture, column, row);
    if (inked && !inside) heights.push_back(0);
    if (inked) ++heights.back();
    inside = inked;
  }
  return heights;
}

// At a quarter of its size, in a column of a paper, a letter still has six pixels from top to tail.
TEST(AspectView, HasLettersThatCanBeReadAtAQuarterOfItsSize) {
  const FacetMesh mesh = rod();
  const ViewedSweep sweep = sweep_of(mesh);
  AspectView view(sweep, [&](std::size_t row) { return result_of(mesh, row); });
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1600, 1200}, {1600, 900}, {3200, 1800}}) {
    const auto heights = line_heights(view.picture(width, height));
    ASSERT_EQ(heights.size(), 3U) << width;  // title, aspect, LRCS
    for (const int line : heights) EXPECT_GE(line, 24 * width / 1600) << width;
    EXPECT_GE(view.sheet().letters(), 28 * width / 1600);
  }
}

TEST(AspectView, TellsOfAFacetAndItsPartWhatTheyReturnInItsRow) {
  const FacetMesh mesh = rod();
  const ViewedSweep sweep = sweep_of(mesh);
  AspectView view(
      sweep, [&](std::size_t row) { return result_of(mesh, row); }, 1);
  EXPECT_EQ(view.row(), 1U);
  const auto lines = view.pick_facet(3);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].rfind("part right: 14 m² (11.46 dBsm), 70.0 %", 0), 0U) << lines[0];
  EXPECT_EQ(lines[1].rfind("facet 3: 8 m²", 0), 0U) << lines[1];
  EXPECT_TRUE(view.pick_facet(std::nullopt).empty());
  EXPECT_THROW(view.go_to(2), std::out_of_range);
}

TEST(PartReturns, AddUpAndComeStrongestFirst) {
  const FacetMesh mesh = rod();
  EXPECT_EQ(part_returns(mesh, {1e16, 1.0, -1e16, 3.0})[0], 1e16 + 1.0);
  EXPECT_EQ(part_returns(mesh, {1.0, 2.0, 3.0, 4.0}), (std::vector<double>{3.0, 7.0}));
  EXPECT_EQ(strongest_parts({1.0, 0.0, 5.0, 5.0, 2.0}, 3), (std::vector<std::uint32_t>{2, 3, 4}));
  EXPECT_EQ(strongest_parts({1.0, 0.0}, 9), (std::vector<std::uint32_t>{0}));
}

TEST(ColouredFacets, MeanWhatTheirScaleSays) {
  const TwoPlates plates = two_plates();
  FacetShowing showing;
  const auto decibels = coloured_facets(plates.mesh, plates.result, showing);
  EXPECT_EQ(decibels.colours.size(), plates.mesh.size());
  EXPECT_EQ(rgb_of(decibels.colours[0]), rgb_of(viridis(1.0)));
  EXPECT_EQ(rgb_of(decibels.colours[2]), rgb_of(viridis(0.5)));  // 20 dB below
  EXPECT_EQ(decibels.scale.low, -40.0);
  TwoPlates smaller = plates;
  smaller.mesh.areas[0] = 0.25;  // half of it: twice as bright
  EXPECT_EQ(rgb_of(coloured_facets(smaller.mesh, smaller.result, showing).colours[2]),
            rgb_of(viridis(1.0 - (20.0 + 10.0 * std::log10(2.0)) / 40.0)));
  showing.in_decibels = false;
  showing.per_area = false;
  const auto linear = coloured_facets(plates.mesh, plates.result, showing);
  EXPECT_EQ(linear.scale.high, *std::max_element(plates.result.sigma_m2.begin(), plates.result.sigma_m2.end()));
  showing.quantity = FacetQuantity::part;
  const auto parts = coloured_facets(plates.mesh, plates.result, showing);
  EXPECT_FALSE(parts.scale.has_unseen);
  EXPECT_EQ(parts.scale.names.size(), plates.mesh.part.names.size());
}

TEST(ShortenedText, KeepsTheEndThatFits) {
  const Font font{20, false};
  EXPECT_EQ(shortened("bolt", font, 500.0), "bolt");
  const std::string name = "assembly/bracket:2/nut-bolt:1/bolt";
  const std::string end = shortened(name, font, 150.0);
  EXPECT_LE(text_size(end, font).width, 150.0);
  EXPECT_TRUE(end.starts_with("…") && name.ends_with(end.substr(std::string("…").size()))) << end;
  EXPECT_GT(text_size(end, font).width, 120.0);
}

TEST(ShortenedTexts, KeepApartWhatDiffers) {
  const Font font{20, false};
  const auto bolt = [](int assembly, int k) {
    return "as1/bracket-assembly:" + std::to_string(assembly) + "/nut-bolt-assembly:" + std::to_string(k) + "/bolt";
  };
  const auto all_differ = [](const std::vector<std::string>& texts) {
    return std::set<std::string>(texts.begin(), texts.end()).size() == texts.size();
  };
  const std::vector<std::vector<std::string>> sets{{bolt(1, 1), bolt(1, 2), bolt(2, 1), bolt(2, 2)},
                                                   {"panel 1 of the left hand wing", "panel 2 of the left hand wing"},
                                                   {"rod", "nut"},
                                                   {"太阳能电池板一一一一一一一一", "太阳能电池板二一一一一一一一"}};
  for (const auto& texts : sets) {
    const ShortenedTexts shown = shortened_apart(texts, font, 150.0);
    EXPECT_TRUE(all_differ(shown.texts)) << texts[0];
    EXPECT_GE(shown.font.size, 12);
    for (const std::string& text : shown.texts) EXPECT_LE(text_size(text, shown.font).width, 150.0) << text;
  }
  EXPECT_EQ(shortened_apart({"rod", "nut"}, font, 150.0).texts, (std::vector<std::string>{"rod", "nut"}));
  EXPECT_EQ(shortened_apart(sets[0], font, 150.0).texts[2], "…:2/…:1/bolt");
  // Nothing keeps these apart.
  const std::string same(200, 'x');
  EXPECT_EQ(shortened_apart({same, "a" + same}, font, 150.0).font.size, 20);
}

TEST(ColouredFacets, HaveTheColoursOfTheirScale) {
  EXPECT_EQ(drawn_colour(viridis(0.4), false, 0.1), rgb_of(viridis(0.4)));
  EXPECT_LT(drawn_colour(viridis(0.4), true, 0.1)[1], rgb_of(viridis(0.4))[1]);
  EXPECT_LT(drawn_colour(unseen_grey, false, -0.1)[0], rgb_of(unseen_grey)[0]);
  EXPECT_EQ(drawn_colour(unseen_grey, false, -1.0), rgb_of(unseen_grey));
}

TEST(ColouredFacets, HaveNoScaleWhereNothingReturns) {
  TwoPlates plates = two_plates();
  plates.result.sigma_m2.assign(plates.mesh.size(), 0.0);
  for (const bool in_decibels : {false, true}) {
    FacetShowing showing;
    showing.in_decibels = in_decibels;
    const auto coloured = coloured_facets(plates.mesh, plates.result, showing);
    EXPECT_EQ(coloured.scale.title, "no return");
    EXPECT_EQ(coloured.scale.low, coloured.scale.high);
    EXPECT_EQ(rgb_of(coloured.colours[0]), rgb_of(viridis(0.0)));
  }
}

}  // namespace
}  // namespace lrcs
