#include "view/private_display.h"

#include <cstdlib>
#include <iostream>

#include "png_pixels.h"
#include "view/x_server.h"

namespace lrcs {
namespace {

TEST(PicturesPossible, SaysWhyNot) {
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        setenv("DISPLAY", ":4711", 1);
        setenv("PATH", "/nonexistent", 1);
        std::string why;
        const bool possible = pictures_possible(&why);
        std::cerr << why;
        std::exit(possible ? 1 : 0);
      },
      testing::ExitedWithCode(0), "DISPLAY=:4711 cannot be reached");
  EXPECT_TRUE(pictures_possible());
}

TEST(PrivateDisplay, IsOneOfItsOwnWhateverDisplaySays) {
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        setenv("DISPLAY", ":4711", 1);
        std::string why;
        const auto display = PrivateDisplay::open(&why);
        std::exit(display != nullptr && display->name() != ":4711" && !display->failed() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(PrivateDisplay, FallsBackToTheUsersAndSurvivesItsLoss) {
  exit_in_fresh_process();
  EXPECT_EXIT(
      {
        std::string why;
        auto server = XServer::start(&why);
        setenv("DISPLAY", server->display().c_str(), 1);
        setenv("PATH", "/nonexistent", 1);
        auto display = PrivateDisplay::open(&why);
        if (display == nullptr || display->name() != server->display() || display->failed()) std::exit(1);
        server.reset();
        if (!display->failed()) std::exit(2);
        display.reset();
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace lrcs
