// Remus 100: a torpedo-shaped AUV in six degrees of freedom, steered by rudder, stern plane and
// propeller.
//
//   const Remus100 auv = BuildRemus100({});
//   Remus100State state;
//   state.eta << 0, 0, 20, 0, 0, 0;
//   state = Step(auv, state, {.rudder_rad = 0.1, .propeller_rpm = 1200}, {.floor_z_m = 80}, 0.02);
//
// Frames as in docs/start/glossary.md: x East, y North, z down, psi from East toward North; a
// positive rudder turns toward +psi. The vehicle neither reads a clock nor draws a random number.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "lib/vehicle/vehicle/hydrodynamics.h"
#include "lib/vehicle/vehicle/remus100_params.h"

namespace shoal {

/// Positions of the actuators, and the commanded ones.
struct Remus100Actuators {
  double rudder_rad = 0;       ///< Positive turns toward +psi.
  double stern_plane_rad = 0;  ///< Positive: bow down. (The `munet` set: bow up.)
  double propeller_rpm = 0;    ///< Negative astern.

  bool operator==(const Remus100Actuators&) const = default;
};

struct Remus100State {
  /// x, y, z in metres and phi, theta, psi in radians. Angles in (-pi, pi], theta in
  /// [-pi/2, pi/2].
  Vector6d eta = Vector6d::Zero();
  Vector6d nu = Vector6d::Zero();  ///< u, v, w, p, q, r: over ground, in the body's frame.
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();  ///< Over ground during the last step.
  Remus100Actuators actuators;
  bool immobilized = false;  ///< It has touched the ground or another vehicle: for good.
};

/// The sea around the vehicle.
struct Remus100Environment {
  Eigen::Vector3d current_mps = Eigen::Vector3d::Zero();  ///< World's frame, over ground.
  double floor_z_m = std::numeric_limits<double>::infinity();
};

/// Longest step that Step takes. Roll is the fastest motion (about one second) and needs 0.05 s or
/// less to be shown well.
inline constexpr double kMaxRemus100Step_s = 0.2;

/// Advances the vehicle by `dt_s`: forces at the old state, velocities by explicit Euler, then the
/// pose by the new velocities (semi-implicit Euler, first order).
///
/// A vehicle below the floor is immobilized where it is found: it keeps its pose and neither moves
/// nor drifts again. Commands and currents that are not finite count as zero; body velocities are
/// kept within 25 m/s and 25 rad/s, so that finite states stay finite.
/// @pre 0 < dt_s <= kMaxRemus100Step_s; state finite
[[nodiscard]] Remus100State Step(const Remus100& auv, const Remus100State& state,
                                 const Remus100Actuators& command,
                                 const Remus100Environment& environment, double dt_s);

/// Returns the velocity of the water in the body's frame, as `auv` sees it.
[[nodiscard]] Eigen::Vector3d CurrentInBody(const Remus100& auv, const Vector6d& eta,
                                            const Eigen::Vector3d& current_mps);

/// Returns kinetic energy relative to the water, added mass included, and the potential energy of
/// the heeled and pitched hull, in joule; none in a neutral vehicle at rest on an even keel.
[[nodiscard]] double Energy(const Remus100& auv, const Remus100State& state,
                            const Remus100Environment& environment);

}  // namespace shoal
