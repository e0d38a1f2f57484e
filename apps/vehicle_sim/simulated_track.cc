#include "apps/vehicle_sim/simulated_track.h"

#include <fmt/format.h>

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"

namespace shoal {

void SimulatedTrack::Reset(const StartPose& /*pose*/, const Water& water) {
  state_ = track_.At(water.time_s);
}

bool SimulatedTrack::Execute(const actuators_t& actuators) {
  return std::isfinite(actuators.thrust_pct) && std::isfinite(actuators.rudder_deg);
}

void SimulatedTrack::Step(const Water& water, double dt_s) {
  state_ = track_.At(water.time_s + dt_s);
}

void SimulatedTrack::Show(const Water& water, nav_t* nav) const {
  const Eigen::Vector2d relative_mps =
      state_.speed_mps * UnitVector(state_.course_rad) - water.velocity_mps;
  const Eigen::Vector2d ahead = UnitVector(state_.heading_rad);
  nav->x_m = state_.position_m.x();
  nav->y_m = state_.position_m.y();
  nav->z_m = state_.position_m.z();
  nav->heading_deg = Wrap360(RadToDeg(state_.heading_rad));
  nav->surge_mps = relative_mps.dot(ahead);
  nav->sway_mps = relative_mps.x() * ahead.y() - relative_mps.y() * ahead.x();
  nav->heave_mps = state_.descent_mps;
  nav->yaw_rate_degps = RadToDeg(state_.turn_radps);
  nav->speed_mps = relative_mps.norm();
  nav->speed_over_ground_mps = state_.speed_mps;
  nav->course_over_ground_deg = Wrap360(RadToDeg(state_.course_rad));
  nav->descent_mps = state_.descent_mps;
  nav->altitude_m = water.floor_z_m ? *water.floor_z_m - state_.position_m.z() : -1;
}

std::string SimulatedTrack::ActuatorsText() const {
  return fmt::format("    Replayed: {} points over {:.1f} s\n", track_.track.fixes().size(),
                     Seconds(track_.track.last_us() - track_.track.first_us()));
}

}  // namespace shoal
