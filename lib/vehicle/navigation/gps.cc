#include "lib/vehicle/navigation/gps.h"

#include "lib/base/time/seconds.h"

namespace shoal {

void GpsUnit::Watch(double depth_m, int64_t utime) {
  if (!start_utime_) {
    start_utime_ = utime;
    if (gps_.starts_hot) fixed_utime_ = utime;
  }
  if (depth_m > gps_.antenna_depth_m) {
    surfaced_utime_.reset();
    has_fix_ = false;
    return;
  }
  if (!surfaced_utime_) {
    surfaced_utime_ = utime;
    const bool is_hot = fixed_utime_ && Seconds(utime - *fixed_utime_) <= gps_.hot_for_s;
    wait_s_ = is_hot ? gps_.hot_fix_s : gps_.cold_fix_s;
  }
  has_fix_ = Seconds(utime - *surfaced_utime_) >= wait_s_;
  if (has_fix_) fixed_utime_ = utime;
}

std::optional<Eigen::Vector2d> GpsUnit::Read(const Eigen::Vector2d& position_m,
                                             int64_t utime) const {
  if (!has_fix_) return std::nullopt;
  Stream draws(key_.With(utime));
  const double east = draws.Normal();
  const double north = draws.Normal();
  return position_m + gps_.noise_m * Eigen::Vector2d(east, north);
}

}  // namespace shoal
