#include "lib/run/orders/clock_watch.h"

#include <fmt/format.h>

#include "lib/base/time/seconds.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

/// False where the state contradicts the order: it is the answer to the order of another sender.
bool AgreesWith(const clock_state_t& state, const clock_command_t& command) {
  if (command.command == "pause") return state.state != "running";
  if (command.command == "resume") return state.state != "paused";
  if (command.command.starts_with("seek")) return true;
  return state.warp == command.warp;
}

}  // namespace

ClockWatch::ClockWatch(clock_command_t command, const std::optional<clock_state_t>& before)
    : command_(std::move(command)), before_(before) {}

bool ClockWatch::OnState(const clock_state_t& state) {
  if (is_settled_) return true;
  if (before_ && state.mission_id == before_->mission_id &&
      state.num_commands <= before_->num_commands) {
    return false;
  }
  // The clock names the command that it refuses, and refuses the same command to every sender.
  const std::string refusal_of_this = command_.command + " refused: ";
  if (state.refusal.starts_with(refusal_of_this)) {
    refusal_ = state.refusal.substr(refusal_of_this.size());
    is_settled_ = true;
  } else if (AgreesWith(state, command_)) {
    is_settled_ = true;
  }
  return is_settled_;
}

std::string ClockText(const clock_state_t& state) {
  const std::string at = fmt::format("at {:.1f} s", Seconds(state.utime));
  if (state.state != "running") return fmt::format("{} {}", Printable(state.state), at);
  return fmt::format("running at warp {}{}", state.warp > 0 ? fmt::format("{}", state.warp) : "max",
                     state.factor > 0 ? fmt::format(" ({:.1f} x real time)", state.factor) : "");
}

}  // namespace shoal
