#pragma once
#include <sys/types.h>

#include <memory>
#include <string>

namespace lrcs {

// An X server of our own (Xvfb): one screen in memory, no network, its own process group.
// It ends with this object, and with this process however that ends: SIGKILL too. It writes nothing to our stderr.
class XServer {
 public:
  // Starts `Xvfb` from PATH and waits until it takes connections, at most 10 s. Null, and *why_not set, if that fails.
  // From the thread that will outlive it: the kernel ends the server with the thread that started it.
  // screen: width x height x bits a pixel.
  static std::unique_ptr<XServer> start(std::string* why_not, const std::string& screen = "64x64x24");
  ~XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  [[nodiscard]] const std::string& display() const { return display_; }  // ":99"
  [[nodiscard]] pid_t process() const { return process_; }

 private:
  explicit XServer(pid_t process) : process_(process) {}

  pid_t process_;
  std::string display_;
};

}  // namespace lrcs
