// Where vehicles will be: what a leader reports of its next waypoint, and what others predict from
// it until its next report.
//
//   const Motion next = PredictAtPoint({p, v}, waypoint_m, {.speed_mps = 2});
//   Motion leader = PredictLeader({.now = {p, v}, .next = next}, seconds_since_report, {});
//   Motion member = PredictMember(last_report, seconds_since_report);
//
// All predictions count from the time stamp of the report, not from its arrival: a packet's delay
// is part of the elapsed time.
#pragma once

#include <Eigen/Core>

namespace shoal {

struct Motion {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
};

/// How a vehicle means to change its speed.
struct SpeedPlan {
  double speed_mps = 0;          ///< Now; with no acceleration that of the propeller's set point.
  double acceleration_mps2 = 0;  ///< Slope of the rpm to speed map times the rate of rpm.
  double max_speed_mps = 2.5;    ///< >= 0.
};

/// Returns a vehicle's motion when it gets to `point_m` on a straight line:
/// v_f = sqrt(max(0, v^2 + 2 a d)), within [0, max_speed]. At the point itself it has the direction
/// of its velocity, and no velocity if it has none. @pre everything finite
[[nodiscard]] Motion PredictAtPoint(const Motion& own, const Eigen::Vector3d& point_m,
                                    const SpeedPlan& plan);

/// What a leader reports: itself, and how it expects to be at its next waypoint.
struct MotionReport {
  Motion now = {};
  Motion next = {};
};

struct PredictionLimits {
  /// No AUV of this size gains or loses speed faster; bounds what two reports close to a waypoint
  /// would make of their difference.
  double max_acceleration_mps2 = 0.5;
};

/// Returns the leader's motion `elapsed_s` after its report, by constant acceleration along the
/// line d to the next point:
///
///   v_i = v . d/|d|     v_f = v_next . d/|d|     a = (v_f^2 - v_i^2) / (2 |d|), within limits
///   p = p_0 + (v_i t + a t^2 / 2) d/|d|          v = v_0 + a t d/|d|
///
/// until it arrives; from there on it keeps `next`'s velocity. Where it moves away from the point
/// and no constant acceleration leads back, it keeps v_i. @pre everything finite, elapsed_s >= 0
[[nodiscard]] Motion PredictLeader(const MotionReport& report, double elapsed_s,
                                   const PredictionLimits& limits);

/// Returns a member's motion `elapsed_s` after its report: constant velocity.
/// @pre everything finite, elapsed_s >= 0
[[nodiscard]] Motion PredictMember(const Motion& last, double elapsed_s);

}  // namespace shoal
