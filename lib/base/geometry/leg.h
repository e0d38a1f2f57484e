// Straight legs between two points, and where a vessel is beside one.
#pragma once

#include <Eigen/Core>

namespace shoal {

/// From one point to another; x East, y North. A leg without length counts as pointing North.
struct Leg {
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_m = Eigen::Vector2d::Zero();
};

[[nodiscard]] double Length(const Leg& leg);

/// Returns the compass course of the leg, [0, 2 pi).
[[nodiscard]] double Course(const Leg& leg);

/// A position in the frame of a leg.
struct TrackPosition {
  double along_m = 0;        ///< From `from_m`, positive toward `to_m`.
  double cross_track_m = 0;  ///< Cross-track error: positive to starboard of the leg.
};

[[nodiscard]] TrackPosition Project(const Leg& leg, const Eigen::Vector2d& position_m);

/// Returns true for a position more than `by_m` past the line through the end of the leg, square to
/// it.
[[nodiscard]] bool IsBeyond(const Leg& leg, const Eigen::Vector2d& position_m, double by_m = 0);

}  // namespace shoal
