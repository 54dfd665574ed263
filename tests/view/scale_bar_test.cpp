#include "view/scale_bar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "svg_reading.h"

namespace lrcs {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

const Box bar{{100.0, 100.0}, {124.0, 500.0}};
constexpr double room = 200.0;

SvgReading drawn(const ColourScale& scale, int letters = 30) {
  Canvas canvas(400, 600, Recording::shapes);
  draw_scale(canvas, bar, room, scale, {letters, false});
  return read_back(canvas);
}

TEST(ScaleBar, LabelsBothLimitsWhateverTheyAre) {
  EXPECT_THAT(drawn({"seen", 0.0, 1.0, false, {}, false}).texts(),
              UnorderedElementsAre("seen", "0", "0.2", "0.4", "0.6", "0.8", "1"));
  EXPECT_THAT(drawn({"return [dB]", -37.0, 0.0, true, {}, true}).texts(),
              UnorderedElementsAre("return [dB]", "≤ −37", "−30", "−20", "−10", "0", "unseen"));
  EXPECT_THAT(drawn({"per facet [m²]", 0.0, 5.41e-7, false, {}, false}).texts(),
              UnorderedElementsAre("per facet [m²]", "0", "1e-07", "2e-07", "3e-07", "4e-07", "5.41e-07"));
}

TEST(ScaleBar, HasRoundMarksHoweverLargeItIs) {
  EXPECT_THAT(drawn({"", 0.0, 2.25e6, false, {}, false}).texts(),
              UnorderedElementsAre("0", "5e+05", "1e+06", "1.5e+06", "2e+06", "2.25e+06"));
  EXPECT_THAT(drawn({"", -200.0, 0.0, true, {}, false}).texts(),
              UnorderedElementsAre("≤ −200", "−150", "−100", "−50", "0"));
  ColourScale angle{"", 0.0, 90.0, false, {}, false, true};
  EXPECT_THAT(drawn(angle).texts(), UnorderedElementsAre("0", "15", "30", "45", "60", "75", "90"));
}

TEST(ScaleBar, SaysOnlyItsTitleWhereNothingReturns) {
  EXPECT_THAT(drawn({"no return", 0.0, 0.0, false, {}, true}).texts(), UnorderedElementsAre("no return", "unseen"));
}

TEST(ScaleBar, LeavesOutMarksThatWouldTouchALimit) {
  EXPECT_THAT(drawn({"", 0.0, 0.95, false, {}, false}, 60).texts(),
              UnorderedElementsAre("0", "0.2", "0.4", "0.6", "0.95"));
}

TEST(ScaleBar, HasRoomForLongLabels) {
  Canvas canvas(400, 600);
  draw_scale(canvas, bar, room, {"", 0.0, 0.000123456, false, {}, false}, {30, false});
  const Picture& picture = canvas.picture();
  const auto right = static_cast<std::size_t>(bar.low.x - 1.8 * 30 + room);
  std::size_t beyond = 0;
  for (std::size_t k = 0; k < picture.rgb.size() / 3; ++k) beyond += k % 400 > right && picture.rgb[3 * k] != 255;
  EXPECT_EQ(beyond, 0U);
}

TEST(ScaleBar, ListsNames) {
  EXPECT_THAT(drawn({"material", 0.0, 1.0, false, {{"paint", ink}, {"", white}}, false}, 24).texts(),
              ElementsAre("material", "paint", "(no name)"));
}

}  // namespace
}  // namespace lrcs
