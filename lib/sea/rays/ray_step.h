// One step of a ray, in water whose speed is bilinear in range and depth.
//
// The ray equations in slowness form, dx/ds = c xi, dxi/ds = -grad c / c^2 (Jensen, Kuperman,
// Porter, Schmidt, Computational Ocean Acoustics, 2nd ed., sec. 3.2), and their derivative by the
// launch angle with them.
#pragma once

#include <Eigen/Core>

namespace shoal {

/// Range, depth, slowness in both directions, time; and the derivative of each by launch angle.
struct RayState {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  Eigen::Vector2d slowness = Eigen::Vector2d::Zero();
  Eigen::Vector2d at_slope = Eigen::Vector2d::Zero();
  Eigen::Vector2d slowness_slope = Eigen::Vector2d::Zero();
  double time_s = 0;

  RayState Plus(const RayState& rate, double step) const {
    return {at + step * rate.at, slowness + step * rate.slowness, at_slope + step * rate.at_slope,
            slowness_slope + step * rate.slowness_slope, time_s + step * rate.time_s};
  }
};

/// The speed in a cell between two depths and two ranges: c + a dr + b dz + d dr dz.
struct SpeedCell {
  double range_m = 0;
  double depth_m = 0;
  double speed_mps = 1500;
  double by_range = 0;
  double by_depth = 0;
  double by_both = 0;

  bool IsLayered() const { return by_range == 0 && by_both == 0; }
  double At(const Eigen::Vector2d& at) const {
    const double r = at.x() - range_m;
    const double z = at.y() - depth_m;
    return speed_mps + by_range * r + by_depth * z + by_both * r * z;
  }
  Eigen::Vector2d GradientAt(const Eigen::Vector2d& at) const {
    return {by_range + by_both * (at.y() - depth_m), by_depth + by_both * (at.x() - range_m)};
  }
};

/// Returns how the ray changes per metre of its way.
[[nodiscard]] RayState RateOf(const RayState& ray, const SpeedCell& cell);

/// Returns the ray after `step_m` of its way within the cell: in closed form where the speed
/// depends on depth alone, else by a Runge-Kutta method of sixth order.
[[nodiscard]] RayState StepOf(const RayState& ray, const SpeedCell& cell, double step_m);

}  // namespace shoal
