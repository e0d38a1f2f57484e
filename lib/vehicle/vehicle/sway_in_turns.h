// How a vehicle slides in a turn: what a filter must know that measures only its speed ahead.
#pragma once

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/vehicle/vehicle/remus100_params.h"

namespace shoal {

/// The sway of a hull that turns at r is -lever r, after a way of about length (linear theory of
/// manoeuvring: Fossen, Handbook of Marine Craft Hydrodynamics, 2021, 6.5). A vehicle that does not
/// slide has neither.
struct SwayInTurns {
  double lever_m = 0;   ///< From the middle of the hull to where it moves straight ahead; >= 0.
  double length_m = 0;  ///< > 0 where lever_m is.
};

/// Returns what the vehicle's model does, in still water at 1.5 m/s with half of its rudder.
[[nodiscard]] SwayInTurns SwayInTurnsOf(const Remus100& auv);

/// Returns the sway to starboard after `dt_s` of turning clockwise at `yaw_rate_radps`.
[[nodiscard]] inline double NextSway(const SwayInTurns& hull, double sway_mps, double forward_mps,
                                     double yaw_rate_radps, double dt_s) {
  if (!(hull.lever_m > 0)) return 0;
  constexpr double kSlowest_mps = 0.2;
  const double time_s = hull.length_m / std::max(std::abs(forward_mps), kSlowest_mps);
  const double keep = Exp(-dt_s / time_s);
  return keep * sway_mps - (1 - keep) * hull.lever_m * yaw_rate_radps;
}

}  // namespace shoal
