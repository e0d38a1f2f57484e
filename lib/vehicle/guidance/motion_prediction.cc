#include "lib/vehicle/guidance/motion_prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

constexpr double kNever_s = std::numeric_limits<double>::infinity();

// Returns when x = v t + a t^2 / 2 first gets to `distance_m` > 0.
double ArrivalTime_s(double distance_m, double v_mps, double a_mps2) {
  if (v_mps <= 0 && a_mps2 <= 0) return kNever_s;
  // v^2 + 2 a d is below zero by rounding only: `a` is not more negative than that.
  const double v_at_point_mps = std::sqrt(std::max(0.0, v_mps * v_mps + 2 * a_mps2 * distance_m));
  if (v_mps < 0) return (v_at_point_mps - v_mps) / a_mps2;
  const double sum_mps = v_mps + v_at_point_mps;
  return sum_mps > 0 ? 2 * distance_m / sum_mps : kNever_s;
}

}  // namespace

Motion PredictAtPoint(const Motion& own, const Eigen::Vector3d& point_m, const SpeedPlan& plan) {
  const Eigen::Vector3d way_m = Plausible(point_m) - Plausible(own.position_m);
  const double distance_m = way_m.norm();
  const double speed_mps = Plausible(plan.speed_mps);
  const double squared = speed_mps * speed_mps + 2 * Plausible(plan.acceleration_mps2) * distance_m;
  const double v_f_mps =
      plan.acceleration_mps2 == 0 ? speed_mps : std::sqrt(std::max(0.0, squared));
  const Eigen::Vector3d velocity_mps = Plausible(own.velocity_mps);
  const Eigen::Vector3d ahead =
      distance_m > 0 ? Eigen::Vector3d(way_m / distance_m) : velocity_mps.stableNormalized();
  return {.position_m = Plausible(point_m),
          .velocity_mps = std::clamp(v_f_mps, 0.0, plan.max_speed_mps) * ahead};
}

Motion PredictLeader(const MotionReport& report, double elapsed_s, const PredictionLimits& limits) {
  const double t_s = Plausible(elapsed_s);
  const Eigen::Vector3d from_m = Plausible(report.now.position_m);
  const Eigen::Vector3d velocity_mps = Plausible(report.now.velocity_mps);
  const Motion next{.position_m = Plausible(report.next.position_m),
                    .velocity_mps = Plausible(report.next.velocity_mps)};
  const Eigen::Vector3d way_m = next.position_m - from_m;
  const double distance_m = way_m.norm();
  if (distance_m == 0) return PredictMember(next, t_s);

  const Eigen::Vector3d ahead = way_m / distance_m;
  const double v_i_mps = velocity_mps.dot(ahead);
  const double v_f_mps = next.velocity_mps.dot(ahead);
  const double a_mps2 = std::clamp((v_f_mps * v_f_mps - v_i_mps * v_i_mps) / (2 * distance_m),
                                   -limits.max_acceleration_mps2, limits.max_acceleration_mps2);
  const double arrival_s = ArrivalTime_s(distance_m, v_i_mps, a_mps2);
  if (arrival_s == kNever_s) {
    return {.position_m = from_m + v_i_mps * t_s * ahead, .velocity_mps = velocity_mps};
  }
  if (t_s >= arrival_s) return PredictMember(next, t_s - arrival_s);
  return {.position_m = from_m + (v_i_mps * t_s + a_mps2 * t_s * t_s / 2) * ahead,
          .velocity_mps = velocity_mps + a_mps2 * t_s * ahead};
}

Motion PredictMember(const Motion& last, double elapsed_s) {
  const Eigen::Vector3d velocity_mps = Plausible(last.velocity_mps);
  return {.position_m = Plausible(last.position_m) + velocity_mps * Plausible(elapsed_s),
          .velocity_mps = velocity_mps};
}

}  // namespace shoal
