#include "lib/run/run/reading_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "lib/base/text/terminal_text.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

constexpr int64_t kFirstAfter_us = 500'000;
constexpr int64_t kBetween_us = 200'000;

}  // namespace

ReadingBar::ReadingBar(std::string path)
    : path_(std::move(path)),
      is_terminal_(isatty(STDERR_FILENO) == 1),
      next_us_(MonotonicMicroseconds() + kFirstAfter_us) {}

void ReadingBar::Show(double share) {
  if (share >= 1) return Clear();
  if (!is_terminal_ || MonotonicMicroseconds() < next_us_) return;
  next_us_ = MonotonicMicroseconds() + kBetween_us;
  is_shown_ = true;
  constexpr int kWidth = 30;
  const int filled = static_cast<int>(std::clamp(share, 0.0, 1.0) * kWidth);
  fmt::print(stderr, "\r\033[Kreading {} [{:#<{}}{:{}}] {:.0f} %", TerminalLine(path_), "", filled,
             "", kWidth - filled, share * 100);
  std::fflush(stderr);
}

void ReadingBar::Clear() {
  if (std::exchange(is_shown_, false)) fmt::print(stderr, "\r\033[K");
}

ReadingBar::~ReadingBar() { Clear(); }

}  // namespace shoal
