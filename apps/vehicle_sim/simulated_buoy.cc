#include "apps/vehicle_sim/simulated_buoy.h"

#include <fmt/format.h>

#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal {

void SimulatedBuoy::Reset(const StartPose& pose, const Water& /*water*/) {
  state_ = BuoyState{};
  state_.anchor_m = state_.position_m = {pose.x_m, pose.y_m};
  heading_deg_ = Wrap360(pose.heading_deg);
}

bool SimulatedBuoy::Execute(const actuators_t& actuators) {
  return std::isfinite(actuators.thrust_pct) && std::isfinite(actuators.rudder_deg);
}

void SimulatedBuoy::Step(const Water& water, double dt_s) {
  state_ = shoal::Step(params_, state_, {}, water.velocity_mps, dt_s);
}

Eigen::Vector3d SimulatedBuoy::position_m() const {
  return {state_.position_m.x(), state_.position_m.y(), 0};
}

void SimulatedBuoy::Show(const Water& water, nav_t* nav) const {
  const Eigen::Vector2d& over_ground = state_.velocity_mps;
  nav->x_m = state_.position_m.x();
  nav->y_m = state_.position_m.y();
  nav->heading_deg = heading_deg_;
  nav->speed_mps = (over_ground - water.velocity_mps).norm();
  nav->speed_over_ground_mps = over_ground.norm();
  nav->course_over_ground_deg =
      over_ground.norm() > 0 ? Wrap360(RadToDeg(HeadingOf(over_ground))) : heading_deg_;
  nav->altitude_m = water.floor_z_m.value_or(-1);
}

std::string SimulatedBuoy::ActuatorsText() const {
  return fmt::format("    Moored: {:.1f} m of {:.1f} m from its anchor\n",
                     (state_.position_m - state_.anchor_m).norm(), params_.watch_radius_m);
}

}  // namespace shoal
