#include "lib/vehicle/vehicle/surface_craft.h"

#include <algorithm>
#include <cmath>

#include "lib/base/check/bounds.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

// Far beyond any vessel: keeps sums finite.
constexpr double kMaxCraftSpeed_mps = 1e6;
constexpr double kMaxCoordinate_m = 1e300;
constexpr double kMaxRudder_deg = 1e6;

SurfaceCraftState Bounded(SurfaceCraftState state) {
  state.position_m = state.position_m.cwiseMin(kMaxCoordinate_m).cwiseMax(-kMaxCoordinate_m);
  state.speed_mps = std::clamp(state.speed_mps, -kMaxCraftSpeed_mps, kMaxCraftSpeed_mps);
  state.rudder_deg = std::clamp(state.rudder_deg, -kMaxRudder_deg, kMaxRudder_deg);
  return state;
}

double Interpolate(const ThrustPoint& low, const ThrustPoint& high, double thrust_pct) {
  const double share = (thrust_pct - low.thrust_pct) / (high.thrust_pct - low.thrust_pct);
  return low.speed_mps + share * (high.speed_mps - low.speed_mps);
}

// Reads the side of the map that `thrust_pct` lies on, outward from (0, 0).
double ReadMap(const std::vector<ThrustPoint>& map, double thrust_pct) {
  ThrustPoint inner;
  const auto read_on = [&](const ThrustPoint& outer) {
    if (std::abs(thrust_pct) <= std::abs(outer.thrust_pct)) {
      inner = {thrust_pct, Interpolate(inner, outer, thrust_pct)};
      return false;
    }
    inner = outer;
    return true;
  };
  if (thrust_pct > 0) {
    for (const ThrustPoint& point : map) {
      if (point.thrust_pct > 0 && !read_on(point)) break;
    }
  } else {
    for (auto point = map.rbegin(); point != map.rend(); ++point) {
      if (point->thrust_pct < 0 && !read_on(*point)) break;
    }
  }
  return inner.speed_mps;
}

// Returns the speed after `dt_s` on the way to `target_mps`. A change of direction is a
// deceleration to zero and then an acceleration.
double ApproachSpeed(const SurfaceCraftParams& params, double speed_mps, double target_mps,
                     double dt_s) {
  const bool turns_round = speed_mps * target_mps < 0;
  const double first_target_mps = turns_round ? 0 : target_mps;
  const bool speeds_up = std::abs(first_target_mps) > std::abs(speed_mps);
  const double limit_mps2 = speeds_up ? params.max_acceleration_mps2 : params.max_deceleration_mps2;
  const double change_mps = first_target_mps - speed_mps;
  const double time_needed_s = std::abs(change_mps) / limit_mps2;
  if (time_needed_s > dt_s) return speed_mps + std::copysign(limit_mps2 * dt_s, change_mps);
  if (!turns_round) return target_mps;
  return ApproachSpeed(params, 0, target_mps, dt_s - time_needed_s);
}

}  // namespace

double SteadySpeed(const SurfaceCraftParams& params, double thrust_pct) {
  if (thrust_pct >= 0) return ReadMap(params.thrust_map, thrust_pct);
  const bool astern_is_mapped =
      !params.thrust_map.empty() && params.thrust_map.front().thrust_pct < 0;
  if (astern_is_mapped) return ReadMap(params.thrust_map, thrust_pct);
  return -params.reverse_ratio * ReadMap(params.thrust_map, -thrust_pct);
}

double ThrustForSpeed(const SurfaceCraftParams& params, double speed_mps) {
  if (!(speed_mps > 0)) return 0;
  ThrustPoint low;
  for (const ThrustPoint& high : params.thrust_map) {
    if (high.thrust_pct <= 0) continue;
    if (high.speed_mps >= speed_mps) {
      const double share = (speed_mps - low.speed_mps) / (high.speed_mps - low.speed_mps);
      return std::min(100.0, low.thrust_pct + share * (high.thrust_pct - low.thrust_pct));
    }
    low = high;
  }
  return 100;
}

SurfaceCraftState Step(const SurfaceCraftParams& params, const SurfaceCraftState& start,
                       const SurfaceCraftCommand& command, const Eigen::Vector2d& current_mps,
                       double dt_s) {
  SHOAL_CHECK(dt_s > 0, "dt_s > 0");
  const SurfaceCraftState state = Bounded(start);
  const double thrust_pct = std::clamp(FiniteOrZero(command.thrust_pct), -100.0, 100.0);
  const double rudder_goal_deg =
      std::clamp(FiniteOrZero(command.rudder_deg), -params.max_rudder_deg, params.max_rudder_deg);
  const double max_swing_deg = params.max_rudder_rate_degps * dt_s;

  SurfaceCraftState next;
  next.rudder_deg = state.rudder_deg +
                    std::clamp(rudder_goal_deg - state.rudder_deg, -max_swing_deg, max_swing_deg);
  const double rudder_share = next.rudder_deg / params.max_rudder_deg;
  const double target_mps =
      SteadySpeed(params, thrust_pct) * (1 - params.turn_speed_loss * std::abs(rudder_share));
  next.speed_mps = ApproachSpeed(params, state.speed_mps, target_mps, dt_s);

  const double mean_speed_mps = 0.5 * (state.speed_mps + next.speed_mps);
  const double mean_rudder_share =
      0.5 * (state.rudder_deg + next.rudder_deg) / params.max_rudder_deg;
  double turn_share = std::clamp(mean_speed_mps / params.full_turn_speed_mps, -1.0, 1.0);
  if (params.full_turn_thrust_pct > 0) {
    turn_share *= std::abs(thrust_pct) / params.full_turn_thrust_pct;
  }
  next.yaw_rate_radps = DegToRad(params.turn_rate_degps) * mean_rudder_share * turn_share;
  next.heading_rad = WrapTwoPi(state.heading_rad + next.yaw_rate_radps * dt_s);

  next.velocity_over_ground_mps =
      0.5 * (state.speed_mps * UnitVector(state.heading_rad) +
             next.speed_mps * UnitVector(next.heading_rad)) +
      current_mps.cwiseMin(kMaxCraftSpeed_mps).cwiseMax(-kMaxCraftSpeed_mps);
  next.position_m = state.position_m + next.velocity_over_ground_mps * dt_s;
  return next;
}

}  // namespace shoal
