// Follows one leg after another: line of sight along the leg, until its end is reached.
#pragma once

#include <Eigen/Core>

#include "lib/base/geometry/leg.h"
#include "lib/vehicle/guidance/alos.h"
#include "lib/vehicle/guidance/task.h"
#include "lib/vehicle/guidance/waypoint_capture.h"

namespace shoal {

class LegFollower {
 public:
  /// Begins at `position_m` with a leg from there to `to_m`.
  LegFollower(const AlosParams& alos, const CaptureRule& capture, const Eigen::Vector2d& position_m,
              const Eigen::Vector2d& to_m);

  /// Returns true once the leg's end counts as reached. A vessel that passed the end and was not
  /// near enough runs on until it has room to turn round, then gets a new leg from where it is.
  [[nodiscard]] bool Reached(const Eigen::Vector2d& position_m);

  /// Goes on from the end of the leg to `to_m`.
  void Continue(const Eigen::Vector2d& position_m, const Eigen::Vector2d& to_m);

  /// Takes the leg up again after the vessel was steered by something else; with a new leg from
  /// `position_m` if that lies beyond its end.
  void Rejoin(const Eigen::Vector2d& position_m);

  /// Returns the compass heading to steer, [0, 2 pi).
  double Steer(const Eigen::Vector2d& position_m, double dt_s);

  const Leg& leg() const { return capture_.leg(); }
  double crab_rad() const { return alos_.crab_rad(); }

 private:
  void Follow(const Leg& next, const Eigen::Vector2d& position_m);

  CaptureRule rule_;
  double turn_room_m_;  ///< Past the end of a leg that was missed.
  Alos alos_;
  WaypointCapture capture_;
};

}  // namespace shoal
