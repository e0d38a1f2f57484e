#include "apps/vehicle_sim/simulated_surface_craft.h"

#include <fmt/format.h>

#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal {

void SimulatedSurfaceCraft::Reset(const StartPose& pose, const Water& water) {
  state_ = SurfaceCraftState{};
  state_.position_m = {pose.x_m, pose.y_m};
  state_.heading_rad = WrapTwoPi(DegToRad(pose.heading_deg));
  state_.speed_mps = pose.speed_mps;
  state_.velocity_over_ground_mps =
      pose.speed_mps * UnitVector(state_.heading_rad) + water.velocity_mps;
}

bool SimulatedSurfaceCraft::Execute(const actuators_t& actuators) {
  if (!std::isfinite(actuators.thrust_pct) || !std::isfinite(actuators.rudder_deg)) return false;
  command_ = {.thrust_pct = actuators.thrust_pct, .rudder_deg = actuators.rudder_deg};
  return true;
}

void SimulatedSurfaceCraft::Step(const Water& water, double dt_s) {
  state_ = shoal::Step(params_, state_, command_, water.velocity_mps, dt_s);
}

Eigen::Vector3d SimulatedSurfaceCraft::position_m() const {
  return {state_.position_m.x(), state_.position_m.y(), 0};
}

void SimulatedSurfaceCraft::Show(const Water& water, nav_t* nav) const {
  const Eigen::Vector2d& over_ground = state_.velocity_over_ground_mps;
  nav->x_m = state_.position_m.x();
  nav->y_m = state_.position_m.y();
  nav->heading_deg = Wrap360(RadToDeg(state_.heading_rad));
  nav->surge_mps = state_.speed_mps;
  nav->yaw_rate_degps = RadToDeg(state_.yaw_rate_radps);
  nav->speed_mps = std::abs(state_.speed_mps);
  nav->speed_over_ground_mps = over_ground.norm();
  nav->course_over_ground_deg =
      over_ground.norm() > 0 ? Wrap360(RadToDeg(HeadingOf(over_ground))) : nav->heading_deg;
  nav->altitude_m = water.floor_z_m.value_or(-1);
}

std::string SimulatedSurfaceCraft::ActuatorsText() const {
  return fmt::format("    Thrust: {:.1f} %, rudder {:.1f} deg (asked for {:.1f})\n",
                     command_.thrust_pct, state_.rudder_deg, command_.rudder_deg);
}

}  // namespace shoal
