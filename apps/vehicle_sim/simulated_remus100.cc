#include "apps/vehicle_sim/simulated_remus100.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/trim.h"

namespace shoal {

namespace {

Remus100Environment EnvironmentOf(const Water& water) {
  Remus100Environment environment;
  environment.current_mps.head<2>() = water.velocity_mps;
  if (water.floor_z_m) environment.floor_z_m = *water.floor_z_m;
  return environment;
}

}  // namespace

SimulatedRemus100::SimulatedRemus100(const Remus100Options& options)
    : model_step_s_(options.model_step_s),
      stern_plane_sign_(options.parameters == "munet" ? 1 : -1),
      auv_(BuildRemus100(ParamsOf(options))) {}

void SimulatedRemus100::Reset(const StartPose& pose, const Water& water) {
  const double psi_rad = PsiFromHeading(DegToRad(pose.heading_deg));
  state_ = Remus100State{};
  // Put at the surface, it floats: it does not fall in from above.
  const double z_m = std::max(pose.depth_m, FloatingDepth(auv_));
  state_.eta << pose.x_m, pose.y_m, z_m, 0, 0, psi_rad;
  state_.nu.head<3>() = CurrentInBody(auv_, state_.eta, EnvironmentOf(water).current_mps) +
                        Eigen::Vector3d(pose.speed_mps, 0, 0);
  const Eigen::Vector2d through_water =
      pose.speed_mps * Eigen::Vector2d(Cos(psi_rad), Sin(psi_rad));
  state_.velocity_mps.head<2>() = through_water + water.velocity_mps;
}

bool SimulatedRemus100::Execute(const actuators_t& actuators) {
  if (!std::isfinite(actuators.rudder_deg) || !std::isfinite(actuators.stern_plane_deg) ||
      !std::isfinite(actuators.propeller_rpm)) {
    return false;
  }
  command_ = {.rudder_rad = -DegToRad(actuators.rudder_deg),
              .stern_plane_rad = stern_plane_sign_ * DegToRad(actuators.stern_plane_deg),
              .propeller_rpm = actuators.propeller_rpm};
  return true;
}

void SimulatedRemus100::Step(const Water& water, double dt_s) {
  const Remus100Environment environment = EnvironmentOf(water);
  // A step that fits up to rounding is not cut in two.
  const double num_steps = std::max(1.0, std::ceil(dt_s / model_step_s_ - 1e-9));
  for (int i = 0; i < static_cast<int>(num_steps); ++i) {
    state_ = shoal::Step(auv_, state_, command_, environment, dt_s / num_steps);
  }
}

void SimulatedRemus100::Show(const Water& water, nav_t* nav) const {
  const Eigen::Vector3d through_water =
      state_.nu.head<3>() - CurrentInBody(auv_, state_.eta, EnvironmentOf(water).current_mps);
  const Eigen::Vector2d over_ground = state_.velocity_mps.head<2>();
  nav->x_m = state_.eta[0];
  nav->y_m = state_.eta[1];
  nav->z_m = state_.eta[2];
  nav->roll_deg = -RadToDeg(state_.eta[3]);
  nav->pitch_deg = RadToDeg(state_.eta[4]);
  nav->heading_deg = Wrap360(RadToDeg(HeadingFromPsi(state_.eta[5])));
  nav->surge_mps = through_water.x();
  nav->sway_mps = -through_water.y();
  nav->heave_mps = through_water.z();
  nav->roll_rate_degps = -RadToDeg(state_.nu[3]);
  nav->pitch_rate_degps = RadToDeg(state_.nu[4]);
  nav->yaw_rate_degps = -RadToDeg(state_.nu[5]);
  nav->speed_mps = through_water.norm();
  nav->speed_over_ground_mps = over_ground.norm();
  nav->course_over_ground_deg =
      over_ground.norm() > 0 ? Wrap360(RadToDeg(HeadingOf(over_ground))) : nav->heading_deg;
  nav->descent_mps = state_.velocity_mps.z();
  nav->altitude_m = water.floor_z_m ? std::max(0.0, *water.floor_z_m - state_.eta[2]) : -1;
}

std::string SimulatedRemus100::ActuatorsText() const {
  const auto line = [](std::string_view name, double is, double asked, std::string_view unit) {
    return fmt::format("    {}: {:.1f} {} (asked for {:.1f})\n", name, is, unit, asked);
  };
  std::string text =
      line("Propeller", state_.actuators.propeller_rpm, command_.propeller_rpm, "rpm");
  text +=
      line("Rudder", -RadToDeg(state_.actuators.rudder_rad), -RadToDeg(command_.rudder_rad), "deg");
  text += line("Stern plane", stern_plane_sign_ * RadToDeg(state_.actuators.stern_plane_rad),
               stern_plane_sign_ * RadToDeg(command_.stern_plane_rad), "deg");
  if (state_.immobilized) text += "    Aground: it moves no more\n";
  return text;
}

}  // namespace shoal
