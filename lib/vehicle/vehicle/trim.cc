#include "lib/vehicle/vehicle/trim.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/attitude.h"
#include "lib/vehicle/vehicle/hydrodynamics.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal {

namespace {

/// Returns how a vehicle on a level way at this speed begins to rise, and to pitch bow up.
Eigen::Vector2d Beginning(const Remus100& auv, double speed_mps, double pitch_rad,
                          double stern_plane_rad) {
  constexpr double kShort_s = 1e-3;
  Remus100State state;
  state.eta[2] = 100;
  state.eta[4] = pitch_rad;
  state.nu.head<3>() = BodyToWorld(0, pitch_rad, 0).transpose() * Eigen::Vector3d(speed_mps, 0, 0);
  state.actuators = {.stern_plane_rad = stern_plane_rad,
                     .propeller_rpm = RpmForSpeed(auv, speed_mps)};
  const Remus100State next = Step(auv, state, state.actuators, {}, kShort_s);
  return {-next.velocity_mps.z() / kShort_s, next.nu[4] / kShort_s};
}

/// Returns the pitch at which neither begins, with the stern planes that hold it; by the slopes at
/// zero, since the angles are small.
double LevelPitch(const Remus100& auv, double speed_mps) {
  constexpr double kTiny_rad = 1e-4;
  const Eigen::Vector2d here = Beginning(auv, speed_mps, 0, 0);
  Eigen::Matrix2d slopes;
  slopes.col(0) = (Beginning(auv, speed_mps, kTiny_rad, 0) - here) / kTiny_rad;
  slopes.col(1) = (Beginning(auv, speed_mps, 0, kTiny_rad) - here) / kTiny_rad;
  return -(slopes.inverse() * here)[0];
}

}  // namespace

LevelTrim LevelTrimOf(const Remus100& auv) {
  if (auv.params.buoyancy_by_weight == 1) return {};
  // Two equations: square U^2 + linear U = -1 / pitch, at 1 and 2 m/s.
  const double at_one = -1 / LevelPitch(auv, 1);
  const double at_two = -1 / LevelPitch(auv, 2);
  const double square = (at_two - 2 * at_one) / 2;
  return {.square_s2pm2 = square, .linear_spm = at_one - square};
}

double PitchOf(const LevelTrim& trim, double speed_mps) {
  constexpr double kSlowest_mps = 1;  // Slower, the fins cannot hold it.
  const double u_mps = std::max(speed_mps, kSlowest_mps);
  const double share = trim.square_s2pm2 * u_mps * u_mps + trim.linear_spm * u_mps;
  return share == 0 ? 0 : -1 / share;
}

double FloatingDepth(const Remus100& auv) {
  if (auv.params.variants.surface != Remus100Variants::Surface::kShare) return 0;
  const double diameter_m = auv.params.diameter_m;
  // The share under water grows with the depth: halve the interval.
  double above_m = -diameter_m / 2;
  double below_m = diameter_m / 2;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double z_m = (above_m + below_m) / 2;
    const bool floats =
        auv.submerged.buoyancy_n * SubmergedShare(z_m, diameter_m) >= auv.submerged.weight_n;
    (floats ? below_m : above_m) = z_m;
  }
  return below_m;
}

double SteepestPitch(const Remus100& auv, double speed_mps) {
  const TailFin& fin = auv.params.stern_plane;
  const double lift_n = 0.5 * auv.params.water_density_kgpm3 * speed_mps * speed_mps * fin.area_m2 *
                        fin.lift_coefficient * auv.params.max_fin_rad;
  const double restoring_nm = auv.submerged.weight_n * auv.params.cg_below_axis_m;
  const double moment_nm = std::abs(fin.x_m) * lift_n;
  return moment_nm < restoring_nm ? Asin(moment_nm / restoring_nm) : kPi / 2;
}

}  // namespace shoal
