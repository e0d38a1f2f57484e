// A kayak-like surface vessel: thrust to speed, rudder to turn rate, limits on both, drift.
//
//   SurfaceCraftState state{.position_m = {0, -20}, .heading_rad = 0};
//   state = Step(params, state, {.thrust_pct = 60, .rudder_deg = -5}, current_mps, 0.1);
//
// The model of uSimMarine's users: thrust sets a target speed through a piecewise linear map,
// turning costs speed, acceleration and deceleration are limited, the rudder turns the vessel in
// proportion to its speed through water, astern the other way round. Unlike there, the turn
// rate does not depend on the thrust, unless `full_turn_thrust_pct` is given: a rudder works by the
// water that flows past it.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace shoal {

/// One point of a thrust map.
struct ThrustPoint {
  double thrust_pct = 0;
  double speed_mps = 0;

  bool operator==(const ThrustPoint&) const = default;
};

struct SurfaceCraftParams {
  /// Speed through water by thrust: linear between the points and (0, 0), flat beyond the first
  /// and the last. Strictly increasing in thrust. Negative thrusts may be given; without them the
  /// vessel goes astern at `reverse_ratio` of its speed ahead.
  std::vector<ThrustPoint> thrust_map = {{100, 5.0}};
  double reverse_ratio = 0.5;          ///< [0, 1].
  double max_acceleration_mps2 = 0.5;  ///< > 0.
  double max_deceleration_mps2 = 0.5;  ///< > 0.
  double max_rudder_deg = 100;         ///< (0, 180]; a rudder in per cent, as MOOS has it, is 100.
  double max_rudder_rate_degps = 200;  ///< How fast the rudder moves; > 0.
  double turn_rate_degps = 35;         ///< At full rudder and at or above `full_turn_speed_mps`.
  double full_turn_speed_mps = 1.5;    ///< Below it the turn rate falls in proportion.
  double full_turn_thrust_pct = 0;  ///< The turn rate is in proportion to the thrust; 0: it is not.
  double turn_speed_loss = 0.4;     ///< Share of the target speed lost at full rudder; [0, 1).

  bool operator==(const SurfaceCraftParams&) const = default;
};

/// x East, y North; psi clockwise from North, as a compass. (Surface craft keep the compass frame
/// throughout; the guidance frame of the AUVs is converted in lib/base/geometry.)
struct SurfaceCraftState {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double heading_rad = 0;     ///< [0, 2 pi).
  double speed_mps = 0;       ///< Through water, ahead positive.
  double rudder_deg = 0;      ///< Where the rudder stands.
  double yaw_rate_radps = 0;  ///< Over the last step; clockwise.
  Eigen::Vector2d velocity_over_ground_mps = Eigen::Vector2d::Zero();  ///< Over the last step.
};

struct SurfaceCraftCommand {
  double thrust_pct = 0;  ///< Clamped to [-100, 100].
  double rudder_deg = 0;  ///< Clamped to +-max_rudder_deg; positive to starboard.
};

/// Advances the vessel by `dt_s` under `command`, in water that moves over ground with
/// `current_mps` (x East, y North). Position by the mean of old and new velocity. NaN or infinite
/// commands count as zero. Finite states stay finite.
/// @pre dt_s > 0, current_mps finite
[[nodiscard]] SurfaceCraftState Step(const SurfaceCraftParams& params,
                                     const SurfaceCraftState& state,
                                     const SurfaceCraftCommand& command,
                                     const Eigen::Vector2d& current_mps, double dt_s);

/// Returns the speed through water that `thrust_pct` keeps up on a straight course.
[[nodiscard]] double SteadySpeed(const SurfaceCraftParams& params, double thrust_pct);

/// Returns the thrust in [0, 100] that keeps up `speed_mps`; 100 where the vessel is not that fast.
[[nodiscard]] double ThrustForSpeed(const SurfaceCraftParams& params, double speed_mps);

}  // namespace shoal
