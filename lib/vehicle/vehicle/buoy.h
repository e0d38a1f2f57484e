// A moored buoy: it drifts with the current until its mooring is taut, and then along its watch
// circle to where the current takes it no farther.
#pragma once

#include <Eigen/Core>

namespace shoal {

struct BuoyParams {
  double watch_radius_m = 20;  ///< It is never farther from its anchor, horizontally.

  bool operator==(const BuoyParams&) const = default;
};

struct BuoyState {
  Eigen::Vector2d anchor_m = Eigen::Vector2d::Zero();  ///< x East, y North.
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();  ///< Over ground, in the last step.
};

/// It takes none.
struct BuoyCommand {};

/// Returns the state `dt_s` > 0 later in a current of `water_velocity_mps`. Where the mooring is
/// taut, the component of the current away from the anchor moves it no more.
[[nodiscard]] BuoyState Step(const BuoyParams& params, const BuoyState& state,
                             const BuoyCommand& command, const Eigen::Vector2d& water_velocity_mps,
                             double dt_s);

}  // namespace shoal
