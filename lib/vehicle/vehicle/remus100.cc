#include "lib/vehicle/vehicle/remus100.h"

#include <algorithm>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/check/check.h"
#include "lib/vehicle/vehicle/attitude.h"
#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal {

namespace {

constexpr double kMaxModelSpeed_mps = 25;
constexpr double kMaxRate_radps = 25;

Vector6d Bounded(const Vector6d& nu) {
  Vector6d bounded;
  bounded.head<3>() = nu.head<3>().cwiseMin(kMaxModelSpeed_mps).cwiseMax(-kMaxModelSpeed_mps);
  bounded.tail<3>() = nu.tail<3>().cwiseMin(kMaxRate_radps).cwiseMax(-kMaxRate_radps);
  return bounded;
}

Remus100Actuators Limited(const Remus100Params& params, const Remus100Actuators& actuators) {
  const double max_rpm = params.propeller.max_rpm;
  return {.rudder_rad = std::clamp(actuators.rudder_rad, -params.max_fin_rad, params.max_fin_rad),
          .stern_plane_rad =
              std::clamp(actuators.stern_plane_rad, -params.max_fin_rad, params.max_fin_rad),
          .propeller_rpm = std::clamp(actuators.propeller_rpm, -max_rpm, max_rpm)};
}

/// First-order lags on the way to `command`. @pre `actuators` within the limits
Remus100Actuators MoveActuators(const Remus100Params& params, const Remus100Actuators& actuators,
                                const Remus100Actuators& command, double dt_s) {
  const bool is_euler = params.variants.euler_actuators;
  const auto share = [&](double time_s) {
    return is_euler ? dt_s / time_s : -Expm1(-dt_s / time_s);
  };
  const double fin_share = share(params.fin_time_s);
  const double propeller_share = share(params.propeller.time_s);
  // A command of any size keeps the result finite.
  const auto approach = [](double from, double to, double part) {
    return from + part * (std::clamp(to, -1e6, 1e6) - from);
  };
  const Remus100Actuators goal = is_euler ? command : Limited(params, command);
  const Remus100Actuators next = {
      .rudder_rad = approach(actuators.rudder_rad, goal.rudder_rad, fin_share),
      .stern_plane_rad = approach(actuators.stern_plane_rad, goal.stern_plane_rad, fin_share),
      .propeller_rpm = approach(actuators.propeller_rpm, goal.propeller_rpm, propeller_share)};
  return params.variants.limits_follow_actuators ? Limited(params, next) : next;
}

// Fossen leaves out terms of the added mass that would make pitch and yaw unstable, as the model
// has no quadratic damping there (the Munk moment among them).
Matrix6d AddedMassCoriolis(const Remus100& auv, const Vector6d& nu_r) {
  Matrix6d coriolis = CoriolisMatrix(auv.added_mass, nu_r);
  if (auv.params.variants.coriolis == Remus100Variants::Coriolis::kOneSided) {
    coriolis(4, 0) = coriolis(4, 3) = coriolis(5, 0) = coriolis(5, 1) = 0;
  } else {
    coriolis(4, 0) = coriolis(0, 4) = coriolis(4, 2) = coriolis(2, 4) = 0;
    coriolis(5, 0) = coriolis(0, 5) = coriolis(5, 1) = coriolis(1, 5) = 0;
  }
  return coriolis;
}

Vector6d DampingForce(const Remus100& auv, const Vector6d& nu_r) {
  const double fade = Exp(-auv.params.damping_fade_spm * nu_r.head<3>().norm());
  Vector6d damping = auv.damping;
  damping[0] *= fade;
  damping[1] *= fade;
  if (auv.params.yaw_damping_fades) damping[5] *= fade;
  return damping.cwiseProduct(nu_r);
}

Hydrostatics HydrostaticsAt(const Remus100& auv, double z_m) {
  Hydrostatics body = auv.submerged;
  switch (auv.params.variants.surface) {
    case Remus100Variants::Surface::kShare:
      body.buoyancy_n *= SubmergedShare(z_m, auv.params.diameter_m);
      break;
    case Remus100Variants::Surface::kNone:
      if (z_m < 0) body.buoyancy_n = 0;
      break;
    case Remus100Variants::Surface::kIgnored:
      break;
  }
  return body;
}

/// Returns the forces of propeller and fins.
Vector6d ActuatorForce(const Remus100& auv, const Vector6d& nu, const Vector6d& nu_r,
                       const Remus100Actuators& actuators) {
  const Remus100Params& params = auv.params;
  const double inflow_mps = params.variants.advance_over_ground ? nu.head<3>().norm() : nu_r[0];
  const PropellerForce propeller =
      ForceOf(params.propeller, params.water_density_kgpm3, actuators.propeller_rpm, inflow_mps);

  const double half_density = 0.5 * params.water_density_kgpm3;
  const double rudder_n = half_density * (nu_r[0] * nu_r[0] + nu_r[1] * nu_r[1]) *
                          params.rudder.area_m2 * params.rudder.lift_coefficient *
                          actuators.rudder_rad;
  const double stern_n = half_density * (nu_r[0] * nu_r[0] + nu_r[2] * nu_r[2]) *
                         params.stern_plane.area_m2 * params.stern_plane.lift_coefficient *
                         actuators.stern_plane_rad;
  const double stern_arm_m =
      params.variants.stern_moment_reversed ? -params.stern_plane.x_m : params.stern_plane.x_m;
  Vector6d tau;
  tau << (1 - params.propeller.thrust_deduction) * propeller.thrust_n -
             rudder_n * actuators.rudder_rad - stern_n * actuators.stern_plane_rad,
      -rudder_n, -stern_n, params.propeller.torque_on_hull * propeller.torque_nm,
      stern_arm_m * stern_n, -params.rudder.x_m * rudder_n;
  return tau;
}

/// Returns the acceleration relative to the water.
Vector6d Acceleration(const Remus100& auv, const Remus100State& state, const Vector6d& nu,
                      const Vector6d& nu_r, const Remus100Actuators& actuators) {
  const Matrix6d coriolis =
      CoriolisMatrix(auv.rigid_body_mass, nu_r) + AddedMassCoriolis(auv, nu_r);
  Vector6d force = ActuatorForce(auv, nu, nu_r, actuators) - coriolis * nu_r -
                   DampingForce(auv, nu_r) -
                   Restoring(HydrostaticsAt(auv, state.eta[2]), state.eta[3], state.eta[4]);
  const LiftDragForce wing = LiftDrag(auv.wing, Atan2(nu_r[2], nu_r[0]), nu_r.head<3>().norm());
  force[0] += wing.surge_n;
  force[2] += wing.heave_n;
  const CrossFlowForce cross_flow = CrossFlowDrag(auv.cross_flow, nu_r[1], nu_r[5]);
  force[1] += cross_flow.sway_n;
  force[5] += cross_flow.yaw_nm;
  return auv.mass_inverse * force;
}

Vector6d Linear(const Eigen::Vector3d& velocity) {
  Vector6d nu = Vector6d::Zero();
  nu.head<3>() = velocity;
  return nu;
}

Eigen::Vector3d TurnedBy(const Eigen::Vector3d& angles_rad, const Vector6d& nu, double dt_s) {
  return NormalizeEuler(
      angles_rad + dt_s * (BodyRatesToEulerRates(angles_rad[0], angles_rad[1]) * nu.tail<3>()));
}

}  // namespace

Eigen::Vector3d CurrentInBody(const Remus100& auv, const Vector6d& eta,
                              const Eigen::Vector3d& current_mps) {
  const Eigen::Vector3d water_mps = Bounded(Linear(current_mps)).head<3>();
  if (!auv.params.variants.current_by_yaw_only) {
    return BodyToWorld(eta[3], eta[4], eta[5]).transpose() * water_mps;
  }
  const auto [spsi, cpsi] = SinCos(eta[5]);
  return {water_mps.x() * cpsi + water_mps.y() * spsi, water_mps.y() * cpsi - water_mps.x() * spsi,
          0};
}

Remus100State Step(const Remus100& auv, const Remus100State& state,
                   const Remus100Actuators& command, const Remus100Environment& environment,
                   double dt_s) {
  SHOAL_CHECK(dt_s > 0 && dt_s <= kMaxRemus100Step_s, "0 < dt_s <= kMaxRemus100Step_s");
  Remus100State next = state;
  if (state.immobilized || state.eta[2] > environment.floor_z_m) {
    next.nu.setZero();
    next.velocity_mps.setZero();
    next.actuators = {};
    next.immobilized = true;
    return next;
  }
  Eigen::Vector3d current_mps = Eigen::Vector3d::Zero();
  if (environment.current_mps.allFinite()) {
    current_mps = Bounded(Linear(environment.current_mps)).head<3>();
  }
  const Remus100Actuators finite_command = {FiniteOrZero(command.rudder_rad),
                                            FiniteOrZero(command.stern_plane_rad),
                                            FiniteOrZero(command.propeller_rpm)};
  const Remus100Actuators actuators = Limited(auv.params, state.actuators);
  const Eigen::Vector3d angles_rad = state.eta.tail<3>();
  const Eigen::Matrix3d rotation = BodyToWorld(angles_rad[0], angles_rad[1], angles_rad[2]);
  const bool is_through_water = !auv.params.variants.current_by_yaw_only;
  const Eigen::Vector3d nu_c = is_through_water
                                   ? Eigen::Vector3d(rotation.transpose() * current_mps)
                                   : CurrentInBody(auv, state.eta, current_mps);
  const Vector6d nu = Bounded(state.nu);
  const Vector6d nu_r = nu - Linear(nu_c);
  const Vector6d acceleration = Acceleration(auv, state, nu, nu_r, actuators);

  next.actuators = MoveActuators(auv.params, actuators, finite_command, dt_s);
  if (is_through_water) {
    // Integrated relative to the water and carried by it: the track over ground is that in still
    // water plus the current's way, to rounding.
    const Vector6d next_nu_r = Bounded(nu_r + dt_s * acceleration);
    next.velocity_mps = rotation * next_nu_r.head<3>() + current_mps;
    next.eta.tail<3>() = TurnedBy(angles_rad, next_nu_r, dt_s);
    next.nu = next_nu_r + Linear(CurrentInBody(auv, next.eta, current_mps));
  } else {
    const Vector6d nu_c_dot = Linear({nu[5] * nu_c[1], -nu[5] * nu_c[0], 0});
    next.nu = Bounded(nu + dt_s * (nu_c_dot + acceleration));
    next.velocity_mps = rotation * next.nu.head<3>();
    next.eta.tail<3>() = TurnedBy(angles_rad, next.nu, dt_s);
  }
  next.eta.head<3>() = state.eta.head<3>() + dt_s * next.velocity_mps;
  return next;
}

double Energy(const Remus100& auv, const Remus100State& state,
              const Remus100Environment& environment) {
  const Vector6d nu_r =
      Bounded(Bounded(state.nu) - Linear(CurrentInBody(auv, state.eta, environment.current_mps)));
  const double heeled = 1 - Cos(state.eta[3]) * Cos(state.eta[4]);
  return 0.5 * nu_r.dot(auv.mass * nu_r) +
         auv.submerged.weight_n * auv.params.cg_below_axis_m * heeled;
}

}  // namespace shoal
