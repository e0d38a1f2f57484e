#include "lib/tools/trials/campaign_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "lib/base/time/seconds.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

constexpr int64_t kOnTerminal_us = 500'000;
constexpr int64_t kElsewhere_us = 30'000'000;
constexpr char kStartOfLine[] = "\r\033[K";

}  // namespace

std::string DurationText(double seconds) {
  constexpr double kMinute = 60;
  constexpr double kHour = 3600;
  if (seconds < 2) return fmt::format("{:.1f} s", seconds);
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

CampaignProgress::CampaignProgress(bool is_quiet)
    : is_quiet_(is_quiet),
      on_terminal_(isatty(STDOUT_FILENO) == 1),
      begin_us_(MonotonicMicroseconds()),
      next_us_(begin_us_ + (on_terminal_ ? kOnTerminal_us : kElsewhere_us)) {}

std::string CampaignProgress::Line(int64_t num_finished, int64_t num_planned,
                                   int64_t wall_us) const {
  const double wall_s = std::max(Seconds(wall_us - begin_us_), 1e-3);
  const auto num_run =
      static_cast<double>(std::accumulate(counts_.begin(), counts_.end(), int64_t{0}));
  const double rate = num_run / wall_s;
  std::string line = fmt::format("{} of {} ({:.0f} %)  {:.3g} per s", num_finished, num_planned,
                                 100.0 * static_cast<double>(num_finished) /
                                     static_cast<double>(std::max<int64_t>(num_planned, 1)),
                                 rate);
  for (size_t i = 0; i < counts_.size(); ++i) {
    line += fmt::format("  {} {}", counts_[i], NameOf(static_cast<TrialOutcome>(i)));
  }
  if (rate > 0) {
    line += fmt::format("  {} left",
                        DurationText(static_cast<double>(num_planned - num_finished) / rate));
  }
  return line;
}

void CampaignProgress::Show(int64_t num_finished, int64_t num_planned, int64_t wall_us,
                            const std::string& note) {
  if (is_quiet_ || wall_us < next_us_) return;
  next_us_ = wall_us + (on_terminal_ ? kOnTerminal_us : kElsewhere_us);
  const std::string line = Line(num_finished, num_planned, wall_us) + note;
  if (on_terminal_) {
    fmt::print("{}{}", kStartOfLine, line);
  } else {
    fmt::print("{}\n", line);
  }
  std::fflush(stdout);
  is_shown_ = on_terminal_;
}

void CampaignProgress::End() {
  if (is_shown_) fmt::print("{}", kStartOfLine);
  is_shown_ = false;
  std::fflush(stdout);
}

}  // namespace shoal
