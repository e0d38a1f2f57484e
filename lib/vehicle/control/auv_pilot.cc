#include "lib/vehicle/control/auv_pilot.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

/// A bound is held more tightly than a depth: it is looked at ahead, which damps. Tuned in
/// floor_keeping_test.cc.
constexpr double kBoundGain = 1.5;
constexpr double kNoFloor_m = std::numeric_limits<double>::infinity();
/// Faster than any vehicle, and deeper than any sea: keeps sums finite.
constexpr double kMaxPlausibleSpeed_mps = 1e3;
constexpr double kMaxPlausibleDepth_m = 1e6;

/// Returns the motion, where it is beyond anything that a vehicle does, as the nearest that is not.
AuvMotion Plausible(AuvMotion motion) {
  motion.z_m = std::clamp(motion.z_m, -kMaxPlausibleDepth_m, kMaxPlausibleDepth_m);
  motion.speed_mps = std::min(motion.speed_mps, kMaxPlausibleSpeed_mps);
  return motion;
}

/// Returns the error from which on the pitch is at its limit: a larger one would only be taken out
/// of the integral, which is missing when the bound is gone again.
double MostError(const DepthPiGains& gains, double along_rad) {
  if (gains.kp <= 0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, gains.max_pitch_rad - along_rad) / gains.kp;
}

}  // namespace

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
          .depth_filter = {.settles_per_step = true},
          .least_speed_mps = 0,
          .feeds_forward = false};
}

double PitchOfDescent(double z_rate_mps, double speed_mps) {
  constexpr double kSlowest_mps = 0.5;
  return -Asin(std::clamp(z_rate_mps / std::max(speed_mps, kSlowest_mps), -1.0, 1.0));
}

void AuvPilot::Start(double psi_rad, double z_m) {
  observer_ = {.psi_d_rad = WrapPi(psi_rad)};
  depth_filter_ = {.z_d_m = z_m};
  heading_ = {};
  pitch_ = {};
  depth_ = {};
  bound_m_ = std::numeric_limits<double>::infinity();
  theta_d_rad_ = 0;
}

AuvDeflections AuvPilot::KeepHeadingAndDepth(const AuvMotion& given, double psi_ref_rad,
                                             double z_ref_m, const DepthBound& bound, double dt_s,
                                             std::optional<double> path_pitch_rad) {
  const AuvMotion motion = Plausible(given);
  if (motion.speed_mps < params_.least_speed_mps) return Drift(motion);
  observer_.Update(params_.heading_observer_hz, psi_ref_rad, dt_s);
  const double goal_m =
      std::max(params_.least_z_m, LimitDepth(z_ref_m, params_.depth_limits, kNoFloor_m));
  double along_rad = PitchAlong(bound, goal_m, motion.speed_mps);
  if (path_pitch_rad) {
    depth_filter_.z_d_m = goal_m;
    const double path_rad = goal_m == z_ref_m ? *path_pitch_rad : 0;
    along_rad = along_rad == 0 ? path_rad : std::max(path_rad, along_rad);
  }
  MoveDesiredDepth(motion, goal_m, bound.now_m, along_rad, dt_s);
  theta_d_rad_ = depth_.Update(params_.depth, motion.z_m, depth_filter_.z_d_m,
                               motion.is_driven ? dt_s : 0, along_rad + motion.level_rad);
  return Deflect(motion, observer_.psi_d_rad, dt_s);
}

AuvDeflections AuvPilot::KeepHeadingAndPitch(const AuvMotion& given, double psi_d_rad,
                                             double theta_d_rad, const DepthBound& bound,
                                             double dt_s) {
  const AuvMotion motion = Plausible(given);
  if (motion.speed_mps < params_.least_speed_mps) return Drift(motion);
  // The references of the other mode begin where the vehicle is then.
  observer_ = {.psi_d_rad = WrapPi(motion.psi_rad)};
  depth_filter_ = {.z_d_m = motion.z_m};
  theta_d_rad_ = RaisedPitch(motion, theta_d_rad + motion.level_rad, bound, dt_s);
  return Deflect(motion, psi_d_rad, dt_s);
}

AuvDeflections AuvPilot::Drift(const AuvMotion& motion) {
  Start(motion.psi_rad, motion.z_m);
  return {};
}

AuvDeflections AuvPilot::Deflect(const AuvMotion& motion, double psi_d_rad, double dt_s) {
  const double integrated_s = motion.is_driven ? dt_s : 0;
  return {.rudder_rad = heading_.Update(params_.heading, motion.psi_rad, psi_d_rad, motion.r_radps,
                                        integrated_s),
          .stern_plane_rad = pitch_.Update(params_.pitch, motion.theta_rad, theta_d_rad_,
                                           motion.q_radps, integrated_s)};
}

void AuvPilot::MoveDesiredDepth(const AuvMotion& motion, double goal_m, double bound_m,
                                double along_rad, double dt_s) {
  const double highest_m = motion.z_m - MostError(params_.depth, along_rad);
  const double now_m = std::max(bound_m, highest_m);
  // What the filter smooths is the way to the bound; the bound's own slope goes on without lag. A
  // step of it does not.
  const bool is_bound = now_m < goal_m;
  if (is_bound && std::isfinite(bound_m_) && params_.feeds_forward) {
    const double most_m = motion.speed_mps * Sin(params_.depth.max_pitch_rad) * dt_s;
    depth_filter_.z_d_m += std::clamp(now_m - bound_m_, -most_m, most_m);
  }
  bound_m_ = now_m;
  const double z_d_m = depth_filter_.Update(params_.depth_filter, std::min(goal_m, now_m), dt_s);
  if (is_bound) depth_filter_.z_d_m = std::max(params_.least_z_m, std::min(z_d_m, now_m));
}

double AuvPilot::PitchAlong(const DepthBound& bound, double goal_m, double speed_mps) const {
  if (!params_.feeds_forward) return 0;
  const double rise_mps = std::min(goal_m, bound.soon_m) - std::min(goal_m, bound.later_m);
  const double steepest = Sin(params_.depth.max_pitch_rad);
  return Asin(std::clamp(rise_mps / speed_mps, -steepest, steepest));
}

double AuvPilot::RaisedPitch(const AuvMotion& motion, double theta_d_rad, const DepthBound& bound,
                             double dt_s) {
  const double deepest_m = params_.depth_limits.max_z_m;
  const double along_rad = PitchAlong(bound, deepest_m, motion.speed_mps) + motion.level_rad;
  // Compared where a pitch that is asked for now will have come about: so a dive ends in time. Far
  // above the bound this asks for a dive steeper than any.
  const double z_soon_m =
      motion.z_m - motion.speed_mps * Sin(motion.theta_rad) * DepthBound::kLead_s;
  const DepthPiGains gains = {.kp = kBoundGain * params_.depth.kp,
                              .ki = kBoundGain * params_.depth.ki,
                              .max_pitch_rad = params_.depth.max_pitch_rad};
  const double soon_m =
      std::max(std::min(deepest_m, bound.soon_m), z_soon_m - MostError(gains, along_rad));
  const double least_rad =
      gains.kp * (z_soon_m - soon_m) + gains.ki * depth_.integral_ms + along_rad;
  if (theta_d_rad >= least_rad) {
    depth_ = {};
    return theta_d_rad;
  }
  return depth_.Update(gains, z_soon_m, soon_m, motion.is_driven ? dt_s : 0, along_rad);
}

}  // namespace shoal
