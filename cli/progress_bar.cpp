#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <utility>

namespace lrcs {

ProgressBar::ProgressBar(std::size_t total, std::string unit, bool wanted)
    : total_(total), unit_(std::move(unit)), shown_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::update(std::size_t done) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (!shown_ || (now - drawn_ < 100ms && done < total_)) return;
  drawn_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r\033[K{}", progress_text(done, total_, seconds, unit_));
}

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string progress_text(std::size_t done, std::size_t total, double seconds, const std::string& unit) {
  constexpr std::size_t width = 30;
  const std::size_t filled = total == 0 ? width : done * width / total;
  const double rate = seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0;
  std::string text = fmt::format("[{:=<{}}{:{}}] {}/{} {}", "", filled, "", width - filled, done, total, unit);
  if (rate > 0.0)
    text += fmt::format("  {:.3g}/s  {} left", rate, clock_text(static_cast<double>(total - done) / rate));
  return text;
}

}  // namespace lrcs
