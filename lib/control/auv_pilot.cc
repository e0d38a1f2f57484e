#include "lib/control/auv_pilot.h"

#include <algorithm>
#include <cmath>

#include "lib/geometry/angles.h"

namespace shoal {

// Pitch: muNet's gains, the sign of the stern plane put right. Heading: muNet's would drive a fin
// of 0.1 s into oscillation; these put both poles of yaw near 1.2 rad/s at 2 m/s. Depth: tuned in
// auv_pilot_test.cc for 700 to 1525 rpm; at 700 rpm the fins hold a pitch of 13 degrees, not 20.
AuvPilotParams DefaultRemusPilot() {
  const double max_fin_rad = DegToRad(15);
  return {.heading = {.kp = -1.0, .ki = -0.1, .kd = -1.0, .max_output_rad = max_fin_rad},
          .pitch = {.kp = 0.36, .ki = 0.21, .kd = 0.13, .max_output_rad = max_fin_rad},
          .depth = {.kp = 0.08, .ki = 0.002, .max_pitch_rad = DegToRad(20)}};
}

AuvPilotParams MunetRemusPilot() {
  const double max_fin_rad = DegToRad(30);
  return {.heading = {.kp = -7.5, .ki = -0.75, .kd = -15, .max_output_rad = max_fin_rad},
          .pitch = {.kp = -0.36, .ki = -0.21, .kd = -0.13, .max_output_rad = max_fin_rad},
          .depth = {.kp = 0.054, .ki = 0.00216, .max_pitch_rad = max_fin_rad},
          .depth_filter = {.settles_per_step = true}};
}

double PitchOfDescent(double z_rate_mps, double speed_mps) {
  constexpr double kSlowest_mps = 0.5;
  return -std::asin(std::clamp(z_rate_mps / std::max(speed_mps, kSlowest_mps), -1.0, 1.0));
}

void AuvPilot::Start(double psi_rad, double z_m) {
  observer_ = {.psi_d_rad = WrapPi(psi_rad)};
  depth_filter_ = {.z_d_m = z_m};
  heading_ = {};
  pitch_ = {};
  depth_ = {};
  theta_d_rad_ = 0;
}

AuvDeflections AuvPilot::KeepHeadingAndDepth(const AuvMotion& motion, double psi_ref_rad,
                                             double z_ref_m, double seabed_z_m, double dt_s,
                                             std::optional<double> path_pitch_rad) {
  observer_.Update(params_.heading_observer_hz, psi_ref_rad, dt_s);
  const double allowed_m = LimitDepth(z_ref_m, params_.depth_limits, seabed_z_m);
  if (path_pitch_rad) depth_filter_.z_d_m = allowed_m;
  const double z_d_m = depth_filter_.Update(params_.depth_filter, allowed_m, dt_s);
  const double pitch_rad = allowed_m == z_ref_m ? path_pitch_rad.value_or(0) : 0;
  theta_d_rad_ = depth_.Update(params_.depth, motion.z_m, z_d_m, dt_s, pitch_rad);
  return {.rudder_rad = heading_.Update(params_.heading, motion.psi_rad, observer_.psi_d_rad,
                                        motion.r_radps, dt_s),
          .stern_plane_rad =
              pitch_.Update(params_.pitch, motion.theta_rad, theta_d_rad_, motion.q_radps, dt_s)};
}

AuvDeflections AuvPilot::KeepHeadingAndPitch(const AuvMotion& motion, double psi_d_rad,
                                             double theta_d_rad, double dt_s) {
  theta_d_rad_ = theta_d_rad;
  return {.rudder_rad =
              heading_.Update(params_.heading, motion.psi_rad, psi_d_rad, motion.r_radps, dt_s),
          .stern_plane_rad =
              pitch_.Update(params_.pitch, motion.theta_rad, theta_d_rad, motion.q_radps, dt_s)};
}

}  // namespace shoal
