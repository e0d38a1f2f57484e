#include "apps/helm/underwater_pilot.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/control/named_pilots.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/trim.h"

namespace shoal {

namespace {

bool IsMunet(const Remus100Options& options) { return options.parameters == "munet"; }

/// Returns the least depth to steer for: the hull just under water, and a quarter of its diameter
/// to swing in.
double LeastDepth(const Remus100& auv) {
  const double z_m = FloatingDepth(auv);
  return z_m > 0 ? z_m + auv.params.diameter_m / 4 : 0;
}

/// The law of pitch damps kd q + heave_kd w, and has one place for both: kd (q + this w).
double HeaveShareOf(const Remus100Options& options) {
  const Remus100Gains gains = GainsOf(options);
  return gains.heave_kd > 0 ? gains.heave_kd / gains.pitch_kd : 0;
}

AuvPilotParams PilotOf(const Remus100Options& options, const Remus100& auv) {
  const Remus100Gains gains = GainsOf(options);
  const std::optional<AuvPilotParams> named = RemusPilotByName(gains.gains);
  SHOAL_CHECK(named.has_value(), "the mission file was checked");
  AuvPilotParams params = *named;
  const double max_fin_rad = DegToRad(gains.max_fin_deg);
  const double plane_sign = IsMunet(options) ? -1 : 1;
  params.heading = {.kp = -gains.heading_kp,
                    .ki = -gains.heading_ki,
                    .kd = -gains.heading_kd,
                    .max_output_rad = max_fin_rad};
  params.pitch = {.kp = plane_sign * gains.pitch_kp,
                  .ki = plane_sign * gains.pitch_ki,
                  .kd = plane_sign * gains.pitch_kd,
                  .max_output_rad = max_fin_rad};
  params.depth = {
      .kp = gains.depth_kp, .ki = gains.depth_ki, .max_pitch_rad = DegToRad(gains.max_pitch_deg)};
  params.heading_observer_hz = gains.heading_observer_hz;
  params.depth_limits = {.max_z_m = options.max_depth_m,
                         .seabed_clearance_m = options.seabed_clearance_m};
  params.least_z_m = LeastDepth(auv);
  params.depth_filter.settles_per_step = options.depth_filter_s == 0;
  if (options.depth_filter_s > 0) params.depth_filter.time_s = options.depth_filter_s;
  return params;
}

void TakeAngles(const Remus100State& state, AuvMotion* motion) {
  motion->z_m = state.eta[2];
  motion->theta_rad = state.eta[4];
  motion->psi_rad = state.eta[5];
  motion->q_radps = state.nu[4];
  motion->r_radps = state.nu[5];
}

AuvMotion MotionOf(const nav_t& nav) {
  return {.z_m = nav.z_m,
          .theta_rad = DegToRad(nav.pitch_deg),
          .psi_rad = PsiFromHeading(DegToRad(nav.heading_deg)),
          .q_radps = DegToRad(nav.pitch_rate_degps),
          .r_radps = -DegToRad(nav.yaw_rate_degps),
          .speed_mps = nav.speed_mps};
}

/// Where the desired speed and pitch lead within kDepthAhead_s: the depth wanted of a task that
/// commands a pitch.
double DepthAhead(const Guidance& guidance, const nav_t& nav) {
  constexpr double kDepthAhead_s = 10;
  const double descent_mps = -guidance.speed_mps * Sin(*guidance.pitch_rad);
  return std::max(0.0, nav.z_m + kDepthAhead_s * descent_mps);
}

std::optional<double> PathPitch(const Guidance& guidance, const nav_t& nav) {
  if (!guidance.z_rate_mps) return std::nullopt;
  return PitchOfDescent(*guidance.z_rate_mps, nav.speed_mps);
}

}  // namespace

UnderwaterPilot::UnderwaterPilot(const Remus100Options& options, const SonarOptions& sonar,
                                 std::optional<SeaFloor> chart)
    : options_(options),
      auv_(BuildRemus100(ParamsOf(options))),
      pilot_(PilotOf(options, auv_)),
      floor_(options, sonar, std::move(chart)),
      heave_share_(HeaveShareOf(options)),
      level_trim_(LevelTrimOf(auv_)) {
  if (GainsOf(options).gains == "munet") ahead_.emplace(auv_, options.model_step_s);
}

double UnderwaterPilot::ClimbAt(double speed_mps) const {
  constexpr double kShare = 0.8;
  const double held_rad =
      std::min(pilot_.params().depth.max_pitch_rad, SteepestPitch(auv_, speed_mps));
  return std::max(0.0, speed_mps) * Sin(kShare * held_rad);
}

double UnderwaterPilot::RpmOf(const Guidance& guidance) const {
  if (guidance.propeller_rpm) return *guidance.propeller_rpm;
  if (guidance.speed_mps <= 0) return 0;
  return IsMunet(options_) ? MunetRpmFromSpeed(guidance.speed_mps)
                           : RpmForSpeed(auv_, guidance.speed_mps);
}

void UnderwaterPilot::Steer(const Guidance& guidance, const nav_t& nav, double dt_s,
                            desired_t* desired, actuators_t* actuators) {
  AuvMotion motion = MotionOf(nav);
  if (rests_) {
    pilot_.Start(motion.psi_rad, motion.z_m);
    if (ahead_) ahead_->Start();
  }
  rests_ = false;
  desired->heading_deg = Wrap360(RadToDeg(guidance.heading_rad));
  desired->speed_mps = guidance.speed_mps;
  if (dt_s <= 0) return;  // The first step: there is nothing yet to go by.

  if (ahead_) TakeAngles(ahead_->Predict(nav, dt_s), &motion);
  motion.q_radps += heave_share_ * nav.heave_mps;
  const double max_rpm = auv_.params.propeller.max_rpm;
  const double setpoint_rpm = std::clamp(RpmOf(guidance), -max_rpm, max_rpm);
  const double rate_rpmps = options_.max_propeller_rate_rpmps > 0
                                ? options_.max_propeller_rate_rpmps
                                : std::numeric_limits<double>::infinity();
  rpm_ = RampRpm(rpm_, setpoint_rpm, rate_rpmps, dt_s);

  motion.is_driven = rpm_ != 0;
  motion.level_rad = PitchOf(level_trim_, motion.speed_mps);

  const double psi_rad = PsiFromHeading(guidance.heading_rad);
  const double turn_rad = WrapPi(guidance.heading_rad - DegToRad(nav.heading_deg));
  const DepthBound bound = floor_.Look(nav, turn_rad, dt_s, ClimbAt(nav.speed_mps));
  const AuvDeflections fins =
      guidance.pitch_rad
          ? pilot_.KeepHeadingAndPitch(motion, psi_rad, *guidance.pitch_rad, bound, dt_s)
          : pilot_.KeepHeadingAndDepth(motion, psi_rad,
                                       guidance.z_m.value_or(options_.cruise_depth_m), bound, dt_s,
                                       PathPitch(guidance, nav));
  if (ahead_) ahead_->Command({fins.rudder_rad, fins.stern_plane_rad, rpm_});
  desired->depth_m = guidance.pitch_rad ? DepthAhead(guidance, nav) : pilot_.desired_z_m();
  const double stern_plane_sign = IsMunet(options_) ? 1 : -1;
  actuators->rudder_deg = -RadToDeg(fins.rudder_rad);
  actuators->stern_plane_deg = stern_plane_sign * RadToDeg(fins.stern_plane_rad);
  actuators->propeller_rpm = rpm_;
  actuators->thrust_pct = 100 * rpm_ / max_rpm;
}

void UnderwaterPilot::Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) {
  rests_ = true;
  floor_.Forget();
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
