#include "apps/helm/underwater_pilot.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "lib/check/check.h"
#include "lib/geometry/angles.h"
#include "lib/vehicle/propulsion.h"

namespace shoal {

namespace {

bool IsMunet(const Remus100Options& options) { return options.parameters == "munet"; }

Remus100 AuvOf(const Remus100Options& options) {
  const std::optional<Remus100Params> params = Remus100ParamsByName(options.parameters);
  SHOAL_CHECK(params.has_value(), "the mission file was checked");
  return BuildRemus100(*params);
}

AuvPilotParams PilotOf(const Remus100Options& options) {
  AuvPilotParams params = IsMunet(options) ? MunetRemusPilot() : DefaultRemusPilot();
  params.depth_limits = {.max_z_m = options.max_depth_m,
                         .seabed_clearance_m = options.seabed_clearance_m};
  params.depth_filter.settles_per_step = options.depth_filter_s == 0;
  if (options.depth_filter_s > 0) params.depth_filter.time_s = options.depth_filter_s;
  return params;
}

AuvMotion MotionOf(const nav_t& nav) {
  return {.z_m = nav.z_m,
          .theta_rad = DegToRad(nav.pitch_deg),
          .psi_rad = PsiFromHeading(DegToRad(nav.heading_deg)),
          .q_radps = DegToRad(nav.pitch_rate_degps),
          .r_radps = -DegToRad(nav.yaw_rate_degps)};
}

std::optional<double> PathPitch(const Guidance& guidance, const nav_t& nav) {
  if (!guidance.z_rate_mps) return std::nullopt;
  return PitchOfDescent(*guidance.z_rate_mps, nav.speed_mps);
}

}  // namespace

UnderwaterPilot::UnderwaterPilot(const Remus100Options& options)
    : options_(options), auv_(AuvOf(options)), pilot_(PilotOf(options)) {}

double UnderwaterPilot::RpmOf(const Guidance& guidance) const {
  if (guidance.propeller_rpm) return *guidance.propeller_rpm;
  if (guidance.speed_mps <= 0) return 0;
  return IsMunet(options_) ? MunetRpmFromSpeed(guidance.speed_mps)
                           : RpmForSpeed(auv_, guidance.speed_mps);
}

void UnderwaterPilot::Steer(const Guidance& guidance, const nav_t& nav, double dt_s,
                            desired_t* desired, actuators_t* actuators) {
  const AuvMotion motion = MotionOf(nav);
  if (rests_) pilot_.Start(motion.psi_rad, motion.z_m);
  rests_ = false;
  desired->heading_deg = Wrap360(RadToDeg(guidance.heading_rad));
  desired->speed_mps = guidance.speed_mps;
  if (dt_s <= 0) return;  // The first step: there is nothing yet to go by.

  const double max_rpm = auv_.params.propeller.max_rpm;
  const double setpoint_rpm = std::clamp(RpmOf(guidance), -max_rpm, max_rpm);
  const double rate_rpmps = options_.max_propeller_rate_rpmps > 0
                                ? options_.max_propeller_rate_rpmps
                                : std::numeric_limits<double>::infinity();
  rpm_ = RampRpm(rpm_, setpoint_rpm, rate_rpmps, dt_s);

  const double psi_rad = PsiFromHeading(guidance.heading_rad);
  const double seabed_z_m =
      nav.altitude_m >= 0 ? nav.z_m + nav.altitude_m : std::numeric_limits<double>::infinity();
  const AuvDeflections fins =
      guidance.pitch_rad ? pilot_.KeepHeadingAndPitch(motion, psi_rad, *guidance.pitch_rad, dt_s)
                         : pilot_.KeepHeadingAndDepth(
                               motion, psi_rad, guidance.z_m.value_or(options_.cruise_depth_m),
                               seabed_z_m, dt_s, PathPitch(guidance, nav));
  desired->depth_m = guidance.pitch_rad ? nav.z_m : pilot_.desired_z_m();
  const double stern_plane_sign = IsMunet(options_) ? 1 : -1;
  actuators->rudder_deg = -RadToDeg(fins.rudder_rad);
  actuators->stern_plane_deg = stern_plane_sign * RadToDeg(fins.stern_plane_rad);
  actuators->propeller_rpm = rpm_;
  actuators->thrust_pct = 100 * rpm_ / max_rpm;
}

void UnderwaterPilot::Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) {
  rests_ = true;
  rpm_ = 0;
  *actuators = {};
  desired->heading_deg = Wrap360(nav.heading_deg);
  desired->speed_mps = 0;
  desired->depth_m = nav.z_m;
}

std::string UnderwaterPilot::GainsText() const {
  return fmt::format("Autopilot of the {} Remus 100; at most {:g} m deep, {:g} m above the floor",
                     options_.parameters, options_.max_depth_m, options_.seabed_clearance_m);
}

}  // namespace shoal
