// The state of the mission's clock, as viewers show it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shoal/clock_state_t.hpp"

namespace shoal {

struct ViewClock {
  /// waiting, gathering, running, paused, ended, lost or recorded.
  std::string state = "waiting";
  std::optional<double> warp = {};    ///< Asked for; 0: as fast as possible.
  std::optional<double> factor = {};  ///< Measured.
  std::vector<std::string> awaited = {};
  std::string note = {};  ///< Why the last command was refused.
};

/// Returns the same of a message; an unknown state counts as running.
[[nodiscard]] ViewClock ViewClockOf(const clock_state_t& clock);

}  // namespace shoal
