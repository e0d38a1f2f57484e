#include "lib/vehicle/guidance/way_among_others.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

/// While layers steer, the vehicle makes for its depth in about this time.
constexpr double kDepthTime_s = 10;
/// As steep as the depth autopilots of lib/vehicle/control go.
constexpr double kSteepest_rad = DegToRad(20);
/// Less than this share of the budget is not worth leaving heading and depth of the path for.
constexpr double kIdle = 0.01;

/// While layers steer, the way back to the leg is no steeper than this: steeper, it would push
/// against what the vehicle keeps clear of, which stands on the leg, and hold it there.
constexpr double kSteepestReturn_rad = DegToRad(20);

/// Returns the course of the path, by ALOS pi_h - beta_hat - atan(y_e / Delta), with that return.
double PsiOfWay(const PathFollowTask& task, const Guidance& path) {
  const double return_rad = Atan(-path.cross_track_error_m / task.lookahead_m);
  return PsiFromHeading(path.heading_rad) + return_rad -
         std::clamp(return_rad, -kSteepestReturn_rad, kSteepestReturn_rad);
}

/// Returns the velocity relative to the water that the path asks for.
Eigen::Vector3d WayOf(const PathFollowTask& task, const Guidance& path, double z_m) {
  const double steepest_mps = path.speed_mps * Sin(kSteepest_rad);
  const double descent_mps =
      path.z_m ? std::clamp((*path.z_m - z_m) / kDepthTime_s, -steepest_mps, steepest_mps) : 0;
  const auto [sine, cosine] = SinCos(PsiOfWay(task, path));
  const double level_mps = std::sqrt(path.speed_mps * path.speed_mps - descent_mps * descent_mps);
  return {level_mps * cosine, level_mps * sine, descent_mps};
}

}  // namespace

// The layers' velocities are over ground, where what they keep clear of is. The path's is relative
// to the water, with the crab angle in its heading: the current is added to it, and taken off the
// sum again. So the path alone comes out as it was, and what stands is kept clear of in a current
// as in still water.
bool KeepClear(const PathFollowTask& task, const Fix& fix, Guidance* guidance) {
  if (fix.surroundings == nullptr) return false;
  const Eigen::Vector3d& current_mps = fix.surroundings->current_mps;
  guidance->u_max_mps = task.u_max_mps;
  const Eigen::Vector3d wanted_mps =
      DesiredVelocityOnWay(task.cascade, task.u_max_mps, *fix.surroundings,
                           WayOf(task, *guidance, fix.z_m) + current_mps, &guidance->layers);
  double asked_mps = 0;
  for (size_t i = 0; i + 1 < guidance->layers.size(); ++i) {
    asked_mps += guidance->layers[i].weight * guidance->layers[i].velocity_mps.norm();
  }
  if (asked_mps < kIdle * task.u_max_mps) return false;
  const TrackCommand command =
      CommandOf(wanted_mps - current_mps, PsiFromHeading(guidance->heading_rad), kSteepest_rad);
  guidance->heading_rad = HeadingFromPsi(command.psi_d_rad);
  guidance->speed_mps = command.speed_mps;
  guidance->pitch_rad = command.theta_d_rad;
  guidance->propeller_rpm.reset();
  return true;
}

}  // namespace shoal
