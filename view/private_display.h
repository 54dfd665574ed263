#pragma once
#include <memory>
#include <string>

namespace lrcs {

// A place where OpenGL can draw 3-D pictures: an Xvfb of our own if one starts, else the user's DISPLAY if it has GLX.
// Tried before VTK sees it: VTK ends the process when a window finds no usable display. Needs no HOME and no writable
// working folder. VTK is handed the connection, so DISPLAY is not changed; only LIBGL_DEBUG=quiet is set where it is
// unset, for Mesa would print. Several programs may draw at once.
// An X error while it lives is noted, not printed, and does not end the process.
// Plots of cuts and BRDFs need none of this.
//
// Draw after computing, from the main thread: Xlib's error handlers and VTK's message window are one for the whole
// process. A graphics driver that crashes takes the process with it: drawing in a forked child was left out, because a
// fork of a program with threads may only call exec. So write results first, pictures last.
class PrivateDisplay {
 public:
  // Null, and *why_not set to one line, if there is no way.
  static std::unique_ptr<PrivateDisplay> open(std::string* why_not);
  ~PrivateDisplay();
  PrivateDisplay(const PrivateDisplay&) = delete;
  PrivateDisplay& operator=(const PrivateDisplay&) = delete;

  [[nodiscard]] void* connection() const;  // Xlib's Display*, for vtkRenderWindow::SetDisplayId
  [[nodiscard]] std::string name() const;  // ":99"
  [[nodiscard]] bool failed() const;       // an X error came, or the connection broke: what was drawn cannot be trusted

 private:
  struct Hidden;
  explicit PrivateDisplay(std::unique_ptr<Hidden> hidden);
  std::unique_ptr<Hidden> hidden_;
};

// Whether 3-D pictures can be drawn here; if not, *why (where given) says in one line why. Takes about 0.1 s.
[[nodiscard]] bool pictures_possible(std::string* why = nullptr);

}  // namespace lrcs
