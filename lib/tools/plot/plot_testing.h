// Small logs for tests of `shoal plot`.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"

namespace shoal {

inline nav_t PlottedNav(int64_t utime, double x_m, double y_m, double z_m = 0) {
  nav_t nav{};
  nav.utime = utime;
  nav.x_m = x_m;
  nav.y_m = y_m;
  nav.z_m = z_m;
  nav.altitude_m = -1;
  return nav;
}

template <class T>
TestEvent EventOf(const std::string& channel, const T& message) {
  return {.utime = message.utime, .channel = channel, .data = Encoded(message)};
}

/// Two vehicles for a minute: alpha goes East at 2 m/s, bravo stays at (0, 30).
inline std::vector<TestEvent> LogOfTwoVehicles() {
  std::vector<TestEvent> events;
  for (int i = 0; i <= 600; ++i) {
    const int64_t utime = i * 100'000;
    nav_t alpha = PlottedNav(utime, 0.2 * i, 0);
    alpha.speed_mps = 2;
    alpha.speed_over_ground_mps = 2;
    alpha.heading_deg = 85;
    alpha.course_over_ground_deg = 90;
    events.push_back(EventOf("NAV_ALPHA", alpha));
    events.push_back(EventOf("NAV_BRAVO", PlottedNav(utime, 0, 30)));
    actuators_t actuators{};
    actuators.utime = utime;
    actuators.thrust_pct = 40;
    events.push_back(EventOf("ACTUATORS_ALPHA", actuators));
    if (i % 10 != 0) continue;
    helm_state_t state{};
    state.utime = utime;
    state.vehicle = "alpha";
    state.state = "DRIVE";
    state.task = "survey";
    state.waypoint_index = 0;
    state.waypoint_x_m = 200;
    state.cross_track_error_m = 1.5;
    events.push_back(EventOf("HELM_STATE_ALPHA", state));
  }
  return events;
}

}  // namespace shoal
