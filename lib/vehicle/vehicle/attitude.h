// Attitude of a vehicle by Euler angles, rotated in the order zyx: yaw psi, pitch theta, roll phi.
//
//   Eigen::Vector3d velocity_mps = BodyToWorld(phi, theta, psi) * nu.head<3>();
//   Eigen::Vector3d angle_rates_radps = BodyRatesToEulerRates(phi, theta) * nu.tail<3>();
//
// World: x East, y North, z down, psi from East toward North, as the guidance frame
// (docs/start/glossary.md).
#pragma once

#include <Eigen/Core>

namespace shoal {

/// Returns R(phi, theta, psi), which turns vectors of the body into vectors of the world. Fossen
/// (2021), Handbook of Marine Craft Hydrodynamics and Motion Control, chapter 2.
[[nodiscard]] Eigen::Matrix3d BodyToWorld(double phi_rad, double theta_rad, double psi_rad);

/// Returns T(phi, theta), which turns body rates (p, q, r) into the rates of (phi, theta, psi).
/// Fossen (2021), chapter 2. It has no limit where the bow points straight up or down; nearer to
/// that than about 0.06 degrees, T of this distance is returned.
[[nodiscard]] Eigen::Matrix3d BodyRatesToEulerRates(double phi_rad, double theta_rad);

/// Returns the angles (phi, theta, psi) of the same attitude with theta in [-pi/2, pi/2] and the
/// others in (-pi, pi].
[[nodiscard]] Eigen::Vector3d NormalizeEuler(const Eigen::Vector3d& angles_rad);

}  // namespace shoal
