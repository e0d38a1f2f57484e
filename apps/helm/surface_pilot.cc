#include "apps/helm/surface_pilot.h"

#include <fmt/format.h>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

HeadingGains HeadingGainsOf(const AutopilotOptions& options) {
  return {.kp = options.heading_kp,
          .ki = options.heading_ki,
          .kd = options.heading_kd,
          .integral_limit_pct = options.heading_integral_limit_deg};
}

SpeedGains SpeedGainsOf(const AutopilotOptions& options, const SurfaceCraftParams& craft) {
  return {.kp = options.speed_kp,
          .ki = options.speed_ki,
          .integral_limit_pct = options.speed_integral_limit_pct,
          .acceleration_mps2 = craft.max_acceleration_mps2};
}

}  // namespace

SurfacePilot::SurfacePilot(const SurfaceCraftParams& craft, const AutopilotOptions& options)
    : craft_(craft),
      options_(options),
      heading_pid_(HeadingGainsOf(options)),
      speed_controller_(SpeedGainsOf(options, craft)) {}

void SurfacePilot::Steer(const Guidance& guidance, const nav_t& nav, double dt_s,
                         desired_t* desired, actuators_t* actuators) {
  desired->heading_deg = Wrap360(RadToDeg(guidance.heading_rad));
  desired->speed_mps = guidance.speed_mps;
  actuators->thrust_pct = speed_controller_.Update(
      guidance.speed_mps, ThrustForSpeed(craft_, guidance.speed_mps), nav.speed_mps, dt_s);
  if (guidance.speed_mps > 0) {
    const double rudder_pct =
        heading_pid_.Update(desired->heading_deg, nav.heading_deg, nav.yaw_rate_degps, dt_s);
    actuators->rudder_deg = rudder_pct / 100 * craft_.max_rudder_deg;
  } else {
    heading_pid_.Reset();
    actuators->rudder_deg = 0;
  }
}

void SurfacePilot::Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) {
  heading_pid_.Reset();
  speed_controller_.Reset();
  actuators->thrust_pct = 0;
  actuators->rudder_deg = 0;
  desired->heading_deg = Wrap360(nav.heading_deg);
  desired->speed_mps = 0;
}

std::string SurfacePilot::GainsText() const {
  return fmt::format("Heading: kp {} ki {} kd {}; speed: kp {} ki {}", options_.heading_kp,
                     options_.heading_ki, options_.heading_kd, options_.speed_kp,
                     options_.speed_ki);
}

}  // namespace shoal
