// What became of an order to the mission's clock, from CLOCK_STATE.
#pragma once

#include <optional>
#include <string>

#include "shoal/clock_command_t.hpp"
#include "shoal/clock_state_t.hpp"

namespace shoal {

class ClockWatch {
 public:
  /// `before`: the last CLOCK_STATE from before the order, if any was received.
  ClockWatch(clock_command_t command, const std::optional<clock_state_t>& before);

  /// Returns true where this state shows what became of the order.
  bool OnState(const clock_state_t& state);

  [[nodiscard]] bool IsSettled() const { return is_settled_; }
  /// Why it was refused; empty: it was taken. @pre IsSettled()
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

 private:
  clock_command_t command_;
  std::optional<clock_state_t> before_;
  bool is_settled_ = false;
  std::string refusal_;
};

/// Returns "paused at 12.3 s", "running at warp 10 (9.8 x real time)" and the like.
[[nodiscard]] std::string ClockText(const clock_state_t& state);

}  // namespace shoal
