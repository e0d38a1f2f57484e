// The NAV channel that a vehicle's own processes use.
#pragma once

#include "lib/bus/channels.h"
#include "lib/mission/mission.h"

namespace shoal {

/// Returns the channel on which the vehicle's processes learn where it is: what it measures, or the
/// truth where the mission gives it no [vehicle.sensors].
[[nodiscard]] inline Channel<nav_t> OwnNav(const Vehicle& vehicle) {
  return vehicle.sensors.is_fitted ? channels::MeasuredNav(vehicle.name)
                                   : channels::Nav(vehicle.name);
}

}  // namespace shoal
