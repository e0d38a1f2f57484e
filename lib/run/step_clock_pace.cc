// StepClock: when steps are due, what it is told of that, and what it tells.
#include <fmt/format.h>

#include <algorithm>

#include "lib/bus/bus.h"
#include "lib/bus/channels.h"
#include "lib/run/status_page.h"
#include "lib/run/step_clock.h"
#include "shoal/clock_state_t.hpp"

namespace shoal {

namespace {

constexpr int64_t kStateInterval_us = 500'000;
constexpr double kHighestWarp = 1e6;
/// No step is due later than a century from the one before; farther times would not fit.
constexpr double kFarthest_us = 3e15;

}  // namespace

/// Does what a command asks for. Returns why not, or an empty text.
std::string StepClock::Obey(const clock_command_t& command, int64_t wall_us) {
  if (state_ == State::kEnding || state_ == State::kEnded) return "the mission is ending";
  const bool is_warp = command.command == "warp";
  if (!is_warp && command.command != "pause" && command.command != "resume") {
    return fmt::format("unknown command '{}': pause, resume or warp", Printable(command.command));
  }
  if (!options_.fixed_pace.empty()) return options_.fixed_pace;
  if (is_warp) {
    // 0 is as fast as possible; so is nothing between it and a step in eleven days.
    const bool ok =
        command.warp == 0 || (command.warp >= 1 / kHighestWarp && command.warp <= kHighestWarp);
    if (!ok) return fmt::format("{} is not 0 (max), nor 1e-6 to 1e6", command.warp);
    SetPace(command.warp, paused_, wall_us);
  } else {
    SetPace(warp_, command.command == "pause", wall_us);
  }
  return {};
}

void StepClock::SetPace(double warp, bool paused, int64_t wall_us) {
  // What changes nothing must not: each command would bring the next step forward.
  if (warp == warp_ && paused == paused_) return;
  warp_ = warp;
  paused_ = paused;
  // The next step comes a whole step after the present one, by the new warp, or now if that has
  // passed; those after it in the new rhythm.
  pace_origin_step_ = step_;
  pace_origin_us_ = ticked_at_us_;
  if (const int64_t due_us = DueTime(); due_us < wall_us) pace_origin_us_ += wall_us - due_us;
  factor_since_us_ = wall_us;
  factor_since_step_ = step_;
  factor_ = 0;
}

/// `is_awaiting`: participants have not said hello yet.
std::string_view StepClock::StateWord(bool is_awaiting) const {
  if (state_ == State::kEnding || state_ == State::kEnded) return "ending";
  if (is_awaiting) return "gathering";
  if (paused_) return "paused";
  return state_ == State::kGathering ? "gathering" : "running";
}

void StepClock::SendState(int64_t wall_us) {
  next_state_us_ = wall_us + kStateInterval_us;
  // The first value after a change comes sooner.
  const int64_t span_us = factor_ > 0 ? 2 * kStateInterval_us : kStateInterval_us;
  if (state_ == State::kRunning && wall_us - factor_since_us_ >= span_us) {
    const auto mission_us = static_cast<double>((step_ - factor_since_step_) * options_.tick_us);
    factor_ = mission_us / static_cast<double>(wall_us - factor_since_us_);
    factor_since_us_ = wall_us;
    factor_since_step_ = step_;
  }
  clock_state_t state{};
  state.utime = utime();
  state.mission_id = options_.mission_id;
  state.step = step_;
  if (state_ == State::kGathering) state.awaited = Awaited();
  state.state = StateWord(!state.awaited.empty());
  state.warp = warp_;
  state.factor = paused_ ? 0 : factor_;
  state.num_commands = num_commands_;
  state.refusal = refusal_;
  state.num_awaited = static_cast<int32_t>(state.awaited.size());
  Bytes bytes;
  EncodeInto(state, &bytes);
  transport_.Send(plan_.tick_port(), channels::ClockState().name, bytes);
}

int64_t StepClock::DueTime() const {
  if (warp_ <= 0) return 0;
  const double mission_us =
      static_cast<double>(step_ + 1 - pace_origin_step_) * static_cast<double>(options_.tick_us);
  return pace_origin_us_ + static_cast<int64_t>(std::min(mission_us / warp_, kFarthest_us));
}

}  // namespace shoal
