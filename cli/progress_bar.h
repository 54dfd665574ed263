#pragma once
#include <chrono>
#include <cstddef>
#include <string>

namespace lrcs {

// A bar on stderr with rate and time left; only where stderr is a terminal. Redrawn ten times a second at most.
class ProgressBar {
 public:
  ProgressBar(std::size_t total, std::string unit, bool wanted);
  ~ProgressBar();  // clears the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void update(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t total_;
  std::string unit_;
  bool shown_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_ = start_;
};

// 75 -> "1:15", 3725 -> "1:02:05".
[[nodiscard]] std::string clock_text(double seconds);

// The bar's text, for a line of 100 characters at most.
[[nodiscard]] std::string progress_text(std::size_t done, std::size_t total, double seconds, const std::string& unit);

}  // namespace lrcs
