// Keeps a way out: how a vehicle with fins turns between obstacles that its sonar knows.
//
//   TurningRoom room;
//   room.Limit(surroundings, psi_rad, u_max_mps, &command);
//
// A propeller carries a vehicle along its bow, not along the velocity that a law wants, and fins
// turn it by its speed relative to the water, on a circle: in open water it needs way to turn,
// before a wall the same way carries it through. So what a law wants is limited:
//
//        slow, slowing toward an echo or about to turn far, and soon too close to go back
//   follows  ───────────────────────────────────────────────────────────────►  goes back
//      ▲                                                                          │
//      └──────────────────────────────────────────────────────────────────────────┘
//                 the turn to where the law wants to go has room again
//
//   follows    the turn to psi_d has room         speed = |v|
//              it has not                         speed = max(0, v . bow)
//   goes back  away from the nearest echo, by the shorter turn, at kSteerage_mps
//
// A turn has room where the circle that it follows, after some way straight on, carried along by
// the current, leads past all echoes. Without echoes there is room everywhere: nothing is limited.
#pragma once

#include "lib/vehicle/guidance/surroundings.h"
#include "lib/vehicle/guidance/target_tracker.h"

namespace shoal {

/// The turning circle is that of a vehicle which gives at least this much rudder ...
inline constexpr double kTurningRudder_deg = 15;
/// ... and whose circle with full rudder is no wider than this (ModelFacts::turning_diameter_m).
inline constexpr double kWidestTurn_m = 45;

class TurningRoom {
 public:
  /// Limits course and speed of `command`, a velocity relative to the water, for a vehicle on
  /// `psi_rad`. @pre u_max_mps > 0
  void Limit(const Surroundings& surroundings, double psi_rad, double u_max_mps,
             TrackCommand* command);

  [[nodiscard]] bool goes_back() const { return side_ != 0; }

 private:
  int side_ = 0;  ///< Of the turn back: +1 toward growing psi, -1; 0: it follows.
};

}  // namespace shoal
