// When a waypoint counts as reached.
#pragma once

#include <Eigen/Core>

#include "lib/base/geometry/leg.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// Watches one vessel on its way along one leg. Tasks and behaviors have the same rule.
class WaypointCapture {
 public:
  /// Begins at `position_m` on the way to `leg.to_m`.
  WaypointCapture(const CaptureRule& rule, const Leg& leg, const Eigen::Vector2d& position_m);

  /// Returns true once the rule holds at `position_m`:
  /// - inside the capture radius, or
  /// - past the closest approach, where that was inside the slip radius. A vessel that only moved
  ///   away so far (it still turns round from the last waypoint) has had no closest approach; or
  /// - past the line through the point, square to the leg, if the rule has a capture line.
  [[nodiscard]] bool Reached(const Eigen::Vector2d& position_m);

  const Leg& leg() const { return leg_; }

 private:
  /// Less than this is noise of the position and not yet coming or going.
  static constexpr double kHysteresis_m = 0.1;

  CaptureRule rule_;
  Leg leg_;
  double farthest_m_;  ///< Before the approach began.
  double closest_m_;   ///< Since the approach began.
  bool approaches_ = false;
};

}  // namespace shoal
