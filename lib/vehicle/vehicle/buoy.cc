#include "lib/vehicle/vehicle/buoy.h"

#include "lib/vehicle/vehicle/vehicle_model.h"

namespace shoal {

static_assert(VehicleModel<BuoyParams, BuoyState, BuoyCommand, Eigen::Vector2d>);

BuoyState Step(const BuoyParams& params, const BuoyState& state, const BuoyCommand& /*command*/,
               const Eigen::Vector2d& water_velocity_mps, double dt_s) {
  BuoyState next = state;
  next.position_m += water_velocity_mps * dt_s;
  const Eigen::Vector2d from_anchor_m = next.position_m - state.anchor_m;
  const double distance_m = from_anchor_m.norm();
  if (distance_m > params.watch_radius_m) {
    next.position_m = state.anchor_m + from_anchor_m * (params.watch_radius_m / distance_m);
  }
  next.velocity_mps = (next.position_m - state.position_m) / dt_s;
  return next;
}

}  // namespace shoal
