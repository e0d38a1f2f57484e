#include "lib/vehicle/guidance/waypoint_capture.h"

#include <algorithm>

namespace shoal {

WaypointCapture::WaypointCapture(const CaptureRule& rule, const Leg& leg,
                                 const Eigen::Vector2d& position_m)
    : rule_(rule),
      leg_(leg),
      farthest_m_((leg.to_m - position_m).norm()),
      closest_m_(farthest_m_) {}

bool WaypointCapture::Reached(const Eigen::Vector2d& position_m) {
  const double distance_m = (leg_.to_m - position_m).norm();
  farthest_m_ = std::max(farthest_m_, distance_m);
  if (!approaches_ && distance_m < farthest_m_ - kHysteresis_m) {
    approaches_ = true;
    closest_m_ = distance_m;
  }
  closest_m_ = std::min(closest_m_, distance_m);

  if (distance_m < rule_.capture_radius_m) return true;
  const bool slips_away = approaches_ && distance_m > closest_m_ + kHysteresis_m;
  if (slips_away && closest_m_ < rule_.slip_radius_m) return true;
  return rule_.capture_line && IsBeyond(leg_, position_m);
}

}  // namespace shoal
