// `lrcs view` in a real window: what keys and mouse do is seen on the screen and in what it prints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <numeric>

#include "lrcs/scene_target.h"
#include "lrcs/sweep.h"
#include "tests/cli/made_scene.h"
#include "tests/cli/program.h"
#include "view/x_server.h"

// Last: their macros are no concern of other headers.
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>

namespace lrcs {
namespace {

using testing::HasSubstr;
constexpr int screen_width = 1600, screen_height = 900;

// The program with a screen, a keyboard and a mouse.
class Desk {
 public:
  Desk(const std::vector<std::string>& arguments, const std::filesystem::path& folder) : folder_(folder) {
    std::string why;
    server_ = XServer::start(&why, "1600x900x24");
    if (server_ == nullptr) throw std::runtime_error(why);
    display_ = XOpenDisplay(server_->display().c_str());
    child_ = fork();
    if (child_ != 0) return;
    const int out = open((folder / "out.txt").c_str(), O_WRONLY | O_CREAT, 0600);
    if (dup2(out, 1) < 0 || dup2(out, 2) < 0) _exit(127);
    become_lrcs(arguments, {folder, {{"DISPLAY", server_->display()}}});
  }
  ~Desk() {
    if (child_ > 0) status_of(child_, 0);
    if (display_ != nullptr) XCloseDisplay(display_);
  }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  [[nodiscard]] std::string said() const { return content_of(folder_ / "out.txt"); }

  void press(KeySym key) const {
    const KeyCode code = XKeysymToKeycode(display_, key);
    XTestFakeKeyEvent(display_, code, 1, CurrentTime);
    XTestFakeKeyEvent(display_, code, 0, CurrentTime);
    XFlush(display_);
  }
  void move(int x, int y) const {
    XTestFakeMotionEvent(display_, -1, x, y, CurrentTime);
    XFlush(display_);
  }
  void button(bool is_down) const {
    XTestFakeButtonEvent(display_, 1, is_down ? 1 : 0, CurrentTime);
    XFlush(display_);
  }
  void click(int x, int y) const {
    move(x, y);
    button(true);
    button(false);
  }

  // All pixels of the screen, 4 bytes each.
  [[nodiscard]] std::string screen() const {
    XImage* image =
        XGetImage(display_, DefaultRootWindow(display_), 0, 0, screen_width, screen_height, AllPlanes, ZPixmap);
    std::string pixels(image->data, static_cast<std::size_t>(image->bytes_per_line) * screen_height);
    XDestroyImage(image);
    return pixels;
  }
  // Waits until something is so, at most 20 s.
  [[nodiscard]] static bool comes(const std::function<bool()>& is_so) {
    for (int k = 0; k < 1000; ++k) {
      if (is_so()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  }
  [[nodiscard]] bool changes(const std::string& from) const {
    return comes([&] { return screen() != from; });
  }
  // Until the screen has been the same for a while.
  [[nodiscard]] std::string still_screen() const {
    std::string before = screen();
    for (int same = 0; same < 20;) {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      std::string now = screen();
      same = now == before ? same + 1 : 0;
      before = std::move(now);
    }
    return before;
  }
  [[nodiscard]] bool shows_window() const {
    return comes([&] {
      const std::string pixels = screen();
      return std::count(pixels.begin(), pixels.end(), '\xff') > screen_width * screen_height;
    });
  }
  void lose_screen() {
    XCloseDisplay(display_);
    display_ = nullptr;
    server_.reset();
  }
  [[nodiscard]] int end() {
    const int status = status_of(child_, 20000);
    child_ = 0;
    return status;
  }

 private:
  std::filesystem::path folder_;
  std::unique_ptr<XServer> server_;
  Display* display_ = nullptr;
  pid_t child_ = 0;
};

class View : public testing::Test {
 protected:
  View() {
    folder_.write("box.stl", two_boxes());
    folder_.write("scene.yaml", good_scene);
    EXPECT_EQ(run_lrcs({"sweep", "scene.yaml", "-o", "out"}, {folder_.path()}).status, 0);
  }
  // What a part returns at a row of the sweep [m^2].
  [[nodiscard]] double part_sigma(std::size_t row, const std::string& part) const {
    const Scene scene = read_scene(folder_.path() / "scene.yaml");
    const LoadedTarget loaded = load_target(scene);
    const Visibility visibility(loaded.target.mesh);
    const Aspect aspect = aspect_of(scene.directions[row], scene.receiver);
    const auto section = cross_section(loaded.target, visibility, aspect.to_transmitter, aspect.to_receiver);
    double sigma = 0.0;
    for (std::size_t k = 0; k < loaded.target.mesh.size(); ++k)
      if (loaded.target.mesh.part.names[loaded.target.mesh.part.of[k]] == part) sigma += section.facet_sigma[k];
    return sigma;
  }
  ScratchFolder folder_;
};

TEST_F(View, EndsWithOneMessageWhereItsScreenIsLost) {
  Desk desk({"view", "out"}, folder_.path());
  ASSERT_TRUE(desk.shows_window()) << desk.said();
  desk.lose_screen();
  EXPECT_EQ(desk.end(), 1);
  EXPECT_EQ(desk.said(), "lrcs: the window is gone: its X server has ended\n");
}

// The number after a word in what was said last.
double number_after(const std::string& text, const std::string& word) {
  const auto at = text.rfind(word);
  return at == std::string::npos ? -1.0 : std::stod(text.substr(at + word.size()));
}

TEST_F(View, FollowsKeysAndMouseAndSaysWhatIsPicked) {
  Desk desk({"view", "out", "--aspect", "1"}, folder_.path());
  ASSERT_TRUE(desk.shows_window()) << desk.said();
  const std::string first = desk.still_screen();

  // Scrub.
  desk.press(XK_Right);
  ASSERT_TRUE(desk.changes(first));
  const std::string second = desk.still_screen();
  desk.press(XK_Left);
  ASSERT_TRUE(desk.changes(second));
  EXPECT_EQ(desk.still_screen(), first);

  // Pick: somewhere there is the panel.
  const auto is_picked = [&] { return desk.said().find("part panel1: ") != std::string::npos; };
  for (int k = 0; k < 81 && !is_picked(); ++k) {
    desk.click(300 + 50 * (k % 9), 400 + 25 * (k / 9));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  ASSERT_TRUE(Desk::comes(is_picked)) << desk.said();
  EXPECT_NEAR(number_after(desk.said(), "part panel1: ") / part_sigma(1, "panel1"), 1.0, 1e-5);

  // Save.
  desk.press(XK_s);
  ASSERT_TRUE(Desk::comes([&] { return folder_.has("out/view-1.png"); })) << desk.said();
  EXPECT_THAT(desk.said(), HasSubstr("saved out/view-1.png"));

  // The slider's end is the last row, and a part of the table says what it returns there.
  desk.move(100, screen_height - 29);
  desk.button(true);
  desk.move(screen_width - 20, screen_height - 29);
  desk.button(false);
  const auto saves_last_row = [&] {
    desk.press(XK_s);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return desk.said().find("saved out/view-4.png") != std::string::npos;
  };
  int tries = 0;
  while (!saves_last_row() && tries < 100) ++tries;
  ASSERT_LT(tries, 100) << desk.said();
  (void)desk.still_screen();
  const auto said_before = desk.said().size();
  const auto says_a_part = [&] { return desk.said().find("part body: ", said_before) != std::string::npos; };
  for (int y = 470; y < 700 && !says_a_part(); y += 12) {
    desk.click(1200, y);
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
  }
  EXPECT_NEAR(number_after(desk.said(), "part body: ") / part_sigma(4, "body"), 1.0, 1e-5) << desk.said();

  // Other colours.
  const std::string last = desk.still_screen();
  desk.press(XK_c);
  EXPECT_TRUE(desk.changes(last));
  desk.press(XK_q);
  EXPECT_EQ(desk.end(), 0);
}

// 16,161 facets, each row computed exactly and drawn. Ten rows a second and more on an idle machine of two cores; this
// one may be busy.
TEST_F(View, ScrubsThroughSixteenThousandFacets) {
  constexpr double seconds = 5.0, fewest = 4.0;
  const std::string scene = std::string(LRCS_EXAMPLES) + "/tess/scene.yaml";
  ASSERT_EQ(run_lrcs({"sweep", scene, "-o", "tess"}, {folder_.path()}).status, 0);
  Desk desk({"view", "tess"}, folder_.path());
  ASSERT_TRUE(desk.shows_window()) << desk.said();
  (void)desk.still_screen();
  desk.press(XK_space);
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  desk.press(XK_space);
  desk.press(XK_s);
  ASSERT_TRUE(Desk::comes([&] { return desk.said().find("saved tess/view-") != std::string::npos; })) << desk.said();
  const double rate = number_after(desk.said(), "saved tess/view-") / seconds;
  std::cout << rate << " rows a second\n";
  EXPECT_GT(rate, fewest);
  desk.press(XK_q);
  EXPECT_EQ(desk.end(), 0);
}

TEST_F(View, DrawsAPictureWithoutADisplay) {
  const Surroundings bare{folder_.path(), {{"DISPLAY", ""}}};
  const Outcome drawn = run_lrcs({"view", "out", "--png", "a.png", "--size", "800x450", "--aspect", "2"}, bare);
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_TRUE(folder_.has("a.png"));
  const Outcome of_scene =
      run_lrcs({"view", "scene.yaml", "--png", "b.png", "--size", "800x450", "--aspect", "2"}, bare);
  EXPECT_EQ(of_scene.status, 0) << of_scene.err;
  EXPECT_EQ(folder_.read("a.png"), folder_.read("b.png"));
}

TEST_F(View, SaysWhatIsWrong) {
  const Surroundings bare{folder_.path(), {{"DISPLAY", ""}}};
  const auto complaint = [&](const std::vector<std::string>& words) { return run_lrcs(with({"view"}, words), bare); };
  EXPECT_THAT(complaint({"out"}).err, HasSubstr("DISPLAY is not set; --png FILE draws without one"));
  EXPECT_EQ(complaint({"out"}).status, 1);
  EXPECT_THAT(complaint({"out", "--png", "a.png", "--aspect", "5"}).err,
              HasSubstr("expected a row of the sweep, 0 to 4"));
  EXPECT_THAT(complaint({"scene.yaml", "--png", "a.png", "--aspect", "5"}).err,
              HasSubstr("expected a row of the sweep, 0 to 4"));
  EXPECT_THAT(complaint({"out", "--png", "a.svg"}).err, HasSubstr("--png: expected a file that ends in .png"));
  EXPECT_THAT(complaint({"out", "--png", "a.png", "--size", "80x450"}).err, HasSubstr("640x360 to 8000x8000"));
  EXPECT_THAT(complaint({"out", "--png", "a.png", "--colour", "red"}).err, HasSubstr("contribution"));
  EXPECT_THAT(complaint({"out", "--png", "a.png", "--aspect", "-1"}).err, HasSubstr("found -1"));
  EXPECT_THAT(complaint({"out", "--png", "a.png", "--range", "nan"}).err, HasSubstr("expected 1 to 200 dB"));
  EXPECT_THAT(complaint({"nowhere"}).err, HasSubstr("nowhere"));
  for (const char* file : {"out/sweep.csv", "out/scene-as-run.yaml"}) {
    const std::string before = folder_.read(file);
    folder_.write(file, before + "\n");
    EXPECT_THAT(complaint({"out", "--png", "a.png"}).err,
                HasSubstr(std::string(file) + ": has changed since the sweep"));
    folder_.write(file, before);
  }
  folder_.write("box.stl", two_boxes() + "\n");
  const Outcome changed = complaint({"out", "--png", "a.png"});
  EXPECT_THAT(changed.err, HasSubstr("box.stl: has changed since the sweep"));
  EXPECT_EQ(changed.status, 2);
  std::filesystem::remove(folder_.path() / "out" / "manifest.json");
  EXPECT_THAT(complaint({"out", "--png", "a.png"}).err, HasSubstr("holds no manifest.json"));
}

}  // namespace
}  // namespace lrcs
