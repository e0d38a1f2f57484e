// For tests: NAV of a Remus 100.
#pragma once

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "shoal/nav_t.hpp"

namespace shoal {

/// Returns NAV of a vehicle in water at rest.
inline nav_t NavOf(const Remus100State& state) {
  nav_t nav{};
  nav.z_m = state.eta[2];
  nav.roll_deg = -RadToDeg(state.eta[3]);
  nav.pitch_deg = RadToDeg(state.eta[4]);
  nav.heading_deg = Wrap360(RadToDeg(HeadingFromPsi(state.eta[5])));
  nav.surge_mps = state.nu[0];
  nav.sway_mps = -state.nu[1];
  nav.heave_mps = state.nu[2];
  nav.roll_rate_degps = -RadToDeg(state.nu[3]);
  nav.pitch_rate_degps = RadToDeg(state.nu[4]);
  nav.yaw_rate_degps = -RadToDeg(state.nu[5]);
  nav.speed_mps = state.nu.head<3>().norm();
  nav.altitude_m = -1;
  return nav;
}

}  // namespace shoal
