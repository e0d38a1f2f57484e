#include "lib/run/run/step_pace.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

/// After a stall the clock does not race to catch up by more than this.
constexpr int64_t kMaxCatchUp_us = 200'000;
constexpr double kHighestWarp = 1e6;
/// No step is due later than a century from the one before; farther times would not fit.
constexpr double kFarthestAhead_us = 3e15;
constexpr int64_t kFactorSpan_us = 1'000'000;
/// The first value after a change comes sooner.
constexpr int64_t kFirstFactorSpan_us = 500'000;

}  // namespace

StepPace::StepPace(double warp, int64_t tick_us, std::string fixed_pace)
    : tick_us_(tick_us), fixed_pace_(std::move(fixed_pace)), warp_(warp) {}

void StepPace::Begin(int64_t wall_us) {
  origin_us_ = wall_us;
  origin_step_ = 0;
  since_us_ = wall_us;
  since_step_ = step_;
}

void StepPace::OnStep(int64_t step, int64_t wall_us) {
  step_ = step;
  began_us_ = wall_us;
}

int64_t StepPace::DueTime() const {
  if (warp_ <= 0) return 0;
  const double mission_us =
      static_cast<double>(step_ + 1 - origin_step_) * static_cast<double>(tick_us_);
  return origin_us_ + static_cast<int64_t>(std::min(mission_us / warp_, kFarthestAhead_us));
}

void StepPace::ForgiveStall(int64_t wall_us) {
  if (DueTime() < wall_us - kMaxCatchUp_us && warp_ > 0) {
    origin_us_ += wall_us - kMaxCatchUp_us - DueTime();
  }
}

std::string StepPace::Execute(const clock_command_t& command, int64_t wall_us) {
  const bool is_warp = command.command == "warp";
  if (command.command.starts_with("seek")) {
    return "a mission cannot be moved in time; the playback of a recording can (shoal play)";
  }
  if (!is_warp && command.command != "pause" && command.command != "resume") {
    return fmt::format("unknown command '{}': pause, resume or warp", Printable(command.command));
  }
  if (!fixed_pace_.empty()) return fixed_pace_;
  if (is_warp) {
    // 0 is as fast as possible; smaller values than a step in eleven days are rejected.
    const bool ok =
        command.warp == 0 || (command.warp >= 1 / kHighestWarp && command.warp <= kHighestWarp);
    if (!ok) return fmt::format("{} is not 0 (max), nor 1e-6 to 1e6", command.warp);
    Set(command.warp, is_paused_, wall_us);
  } else {
    Set(warp_, command.command == "pause", wall_us);
  }
  return {};
}

void StepPace::Set(double warp, bool is_paused, int64_t wall_us) {
  // A command without effect must not move the schedule: each would bring the next step forward.
  if (warp == warp_ && is_paused == is_paused_) return;
  warp_ = warp;
  is_paused_ = is_paused;
  // The next step comes a whole step after the present one, by the new warp, or now if that has
  // passed; those after it in the new rhythm.
  origin_step_ = step_;
  origin_us_ = began_us_;
  if (const int64_t due_us = DueTime(); due_us < wall_us) origin_us_ += wall_us - due_us;
  since_us_ = wall_us;
  since_step_ = step_;
  factor_ = 0;
}

void StepPace::MeasureFactor(int64_t wall_us) {
  const int64_t span_us = factor_ > 0 ? kFactorSpan_us : kFirstFactorSpan_us;
  if (wall_us - since_us_ < span_us) return;
  const auto mission_us = static_cast<double>((step_ - since_step_) * tick_us_);
  factor_ = mission_us / static_cast<double>(wall_us - since_us_);
  since_us_ = wall_us;
  since_step_ = step_;
}

}  // namespace shoal
