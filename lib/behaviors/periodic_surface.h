// Comes up from time to time.
#pragma once

#include <string>
#include <string_view>

#include "lib/behaviors/behavior.h"

namespace shoal {

/// kind = "periodic_surface". Comes up from time to time.
struct PeriodicSurfaceOptions {
  static constexpr std::string_view kKind = "periodic_surface";

  double period = 300;  ///< s between ascents.
  std::string mark_variable =
      "GPS_UPDATE_RECEIVED";  ///< A new setting of it ends the time at the surface.
  double ascent_speed = -1;   ///< m/s; -1: as it is when the ascent begins.
  std::string ascent_grade =
      "linear";  ///< linear, quadratic, quasi or fullspeed: how the speed falls with the depth.
  double zero_speed_depth = 0;       ///< m; the speed is 0 from here up.
  double max_time_at_surface = 300;  ///< s.
  std::string pending_status_var = "PENDING_SURFACE";
  std::string atsurface_status_var = "TIME_AT_SURFACE";

  bool operator==(const PeriodicSurfaceOptions&) const = default;
};

}  // namespace shoal
