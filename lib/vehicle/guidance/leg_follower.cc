#include "lib/vehicle/guidance/leg_follower.h"

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

// On a leg of two look-ahead distances line of sight brings the cross-track error that a turn
// leaves down to a seventh. With less room a vessel could circle round a point without ever
// reaching it.
constexpr double kTurnRoomInLookaheads = 2;

}  // namespace

LegFollower::LegFollower(const AlosParams& alos, const CaptureRule& capture,
                         const Eigen::Vector2d& position_m, const Eigen::Vector2d& to_m)
    : rule_(capture),
      turn_room_m_(kTurnRoomInLookaheads * alos.lookahead_m),
      alos_(alos),
      capture_(rule_, {.from_m = position_m, .to_m = to_m}, position_m) {}

bool LegFollower::Reached(const Eigen::Vector2d& position_m) {
  if (capture_.Reached(position_m)) return true;
  if (IsBeyond(leg(), position_m, turn_room_m_)) {
    Follow({.from_m = position_m, .to_m = leg().to_m}, position_m);
  }
  return false;
}

void LegFollower::Continue(const Eigen::Vector2d& position_m, const Eigen::Vector2d& to_m) {
  Follow({.from_m = leg().to_m, .to_m = to_m}, position_m);
}

void LegFollower::Rejoin(const Eigen::Vector2d& position_m) {
  const Eigen::Vector2d from_m = IsBeyond(leg(), position_m) ? position_m : leg().from_m;
  Follow({.from_m = from_m, .to_m = leg().to_m}, position_m);
}

double LegFollower::Steer(const Eigen::Vector2d& position_m, double dt_s) {
  return WrapTwoPi(alos_.Update(Course(leg()), Project(leg(), position_m).cross_track_m, dt_s));
}

void LegFollower::Follow(const Leg& next, const Eigen::Vector2d& position_m) {
  alos_.TurnBy(Course(next) - Course(leg()));
  capture_ = WaypointCapture(rule_, next, position_m);
}

}  // namespace shoal
