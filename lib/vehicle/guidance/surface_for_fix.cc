#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/task_runner.h"

namespace shoal {

namespace {

/// Up to this depth the vehicle is at the surface: a hull floats half out.
constexpr double kComeUp_m = 0.5;

}  // namespace

SurfaceForFixRunner::SurfaceForFixRunner(const SurfaceForFixTask& task, const Fix& start)
    : task_(task),
      stopwatch_(start.time_s),
      start_m_(start.position_m),
      heading_rad_(start.heading_rad),
      num_fixes_before_(start.num_gps_fixes) {}

Guidance SurfaceForFixRunner::Update(const Fix& fix) {
  const double dt_s = stopwatch_.Lap(fix.time_s);
  elapsed_s_ += dt_s;
  // It comes up on its heading; there it goes round, so that it stays where it is and its fins hold
  // it at the surface.
  is_up_ = is_up_ || fix.z_m <= kComeUp_m;
  if (is_up_) {
    heading_rad_ = WrapTwoPi(heading_rad_ + task_.speed_mps / task_.radius_m * dt_s);
  }
  done_ =
      done_ || fix.num_gps_fixes - num_fixes_before_ >= task_.fixes || elapsed_s_ >= task_.limit_s;
  return {.heading_rad = heading_rad_,
          .speed_mps = task_.speed_mps,
          .done = done_,
          .waypoint_m = start_m_,
          .distance_m = (fix.position_m - start_m_).norm(),
          .z_m = 0.0};
}

}  // namespace shoal
