// The NAV channel that a vehicle's own processes use.
#pragma once

#include "lib/bus/bus/channels.h"
#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns the channel on which the vehicle's processes learn where it is: what its filter
/// estimates ([vehicle.navigation]), what it measures ([vehicle.sensors]), or the truth.
[[nodiscard]] inline Channel<nav_t> OwnNav(const Vehicle& vehicle) {
  if (vehicle.navigation.is_fitted) return channels::EstimatedNav(vehicle.name);
  return vehicle.sensors.is_fitted ? channels::MeasuredNav(vehicle.name)
                                   : channels::Nav(vehicle.name);
}

}  // namespace shoal
