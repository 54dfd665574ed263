#include "view/private_display.h"

#include <GL/glx.h>
#include <X11/Xlib.h>

#include <array>
#include <cstdlib>
#include <utility>

#include "view/x_server.h"

namespace lrcs {
namespace {

// Xlib hands its handlers no pointer of ours.
bool x_error_seen = false;

int note_error(Display* /*display*/, XErrorEvent* /*event*/) {
  x_error_seen = true;
  return 0;
}

int note_lost_connection(Display* /*display*/) {
  x_error_seen = true;
  return 0;
}

// Xlib would call exit().
void stay_alive(Display* /*display*/, void* /*nothing*/) {}

// While one lives, X errors are noted in x_error_seen.
class XErrorsNoted {
 public:
  XErrorsNoted() : error_(XSetErrorHandler(note_error)), lost_(XSetIOErrorHandler(note_lost_connection)) {
    x_error_seen = false;
  }
  ~XErrorsNoted() {
    XSetErrorHandler(error_);
    XSetIOErrorHandler(lost_);
  }
  XErrorsNoted(const XErrorsNoted&) = delete;
  XErrorsNoted& operator=(const XErrorsNoted&) = delete;

 private:
  XErrorHandler error_;
  XIOErrorHandler lost_;
};

struct CloseDisplay {
  void operator()(Display* display) const { XCloseDisplay(display); }
};
using Connection = std::unique_ptr<Display, CloseDisplay>;

Connection connect(const std::string& name) {
  Connection connection(XOpenDisplay(name.c_str()));
  if (connection) XSetIOErrorExitHandler(connection.get(), stay_alive, nullptr);
  return connection;
}

// VTK 9.1 asks for the same kind of context.
GLXContext context_of(Display* display, GLXFBConfig config) {
  using Create = GLXContext (*)(Display*, GLXFBConfig, GLXContext, Bool, const int*);
  const auto create =
      reinterpret_cast<Create>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
  constexpr std::array<int, 5> wanted{GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 2, None};
  return create != nullptr ? create(display, config, nullptr, True, wanted.data()) : nullptr;
}

bool can_draw(Display* display) {
  if (glXQueryExtension(display, nullptr, nullptr) == False) return false;
  constexpr std::array<int, 9> wanted{
      GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT, GLX_RENDER_TYPE, GLX_RGBA_BIT, GLX_RED_SIZE, 8, GLX_DOUBLEBUFFER, True, None};
  int count = 0;
  GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wanted.data(), &count);
  GLXContext context = count > 0 ? context_of(display, configs[0]) : nullptr;
  if (configs != nullptr) XFree(configs);
  if (context != nullptr) glXDestroyContext(display, context);
  XSync(display, False);
  return context != nullptr && !x_error_seen;
}

}  // namespace

struct PrivateDisplay::Hidden {
  std::unique_ptr<XServer> server;  // null: the user's display
  std::string name;
  // Destroyed in reverse: the connection closes while the server still runs and the handlers still stand.
  XErrorsNoted noted;
  Connection connection;
};

PrivateDisplay::PrivateDisplay(std::unique_ptr<Hidden> hidden) : hidden_(std::move(hidden)) {}

PrivateDisplay::~PrivateDisplay() = default;

std::unique_ptr<PrivateDisplay> PrivateDisplay::open(std::string* why_not) {
  // Mesa would print what it cannot load; the user's own setting wins.
  setenv("LIBGL_DEBUG", "quiet", 0);
  auto hidden = std::make_unique<Hidden>();
  hidden->server = XServer::start(why_not);
  if (hidden->server) {
    hidden->name = hidden->server->display();
    hidden->connection = connect(hidden->name);
    if (hidden->connection && can_draw(hidden->connection.get())) {
      return std::unique_ptr<PrivateDisplay>(new PrivateDisplay(std::move(hidden)));
    }
    *why_not = "Xvfb has no OpenGL (Debian package libgl1-mesa-dri)";
    hidden.reset();  // its handlers go before others come
    hidden = std::make_unique<Hidden>();
  }
  const char* users = std::getenv("DISPLAY");
  if (users == nullptr || *users == '\0') {
    *why_not += ", and DISPLAY is not set";
    return nullptr;
  }
  hidden->name = users;
  hidden->connection = connect(hidden->name);
  if (!hidden->connection || !can_draw(hidden->connection.get())) {
    *why_not += ", and DISPLAY=" + hidden->name + (hidden->connection ? " has no OpenGL" : " cannot be reached");
    return nullptr;
  }
  return std::unique_ptr<PrivateDisplay>(new PrivateDisplay(std::move(hidden)));
}

void* PrivateDisplay::connection() const {
  return hidden_->connection.get();
}

std::string PrivateDisplay::name() const {
  return hidden_->name;
}

bool PrivateDisplay::failed() const {
  XSync(hidden_->connection.get(), False);
  return x_error_seen;
}

bool pictures_possible(std::string* why) {
  std::string reason;
  const bool possible = PrivateDisplay::open(&reason) != nullptr;
  if (why != nullptr) *why = possible ? "" : reason;
  return possible;
}

}  // namespace lrcs
