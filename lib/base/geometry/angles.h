// Angles, and the two ways shoal counts directions in the horizontal plane (x East, y North).
//
//   heading  a compass: from North toward East, [0, 2 pi). Surface craft, NAV, node reports.
//   psi      the guidance frame: from East toward North, (-pi, pi]. AUVs and their guidance laws.
//
// All conversions between them are here. NaN and infinite angles give NaN.
#pragma once

#include <Eigen/Core>
#include <numbers>

namespace shoal {

inline constexpr double kPi = std::numbers::pi;

constexpr double DegToRad(double angle_deg) { return angle_deg * (kPi / 180); }
constexpr double RadToDeg(double angle_rad) { return angle_rad * (180 / kPi); }

/// Returns the equal angle in [0, 2 pi).
[[nodiscard]] double WrapTwoPi(double angle_rad);

/// Returns the equal angle in (-pi, pi].
[[nodiscard]] double WrapPi(double angle_rad);

/// Returns the equal angle in [0, 360).
[[nodiscard]] double Wrap360(double angle_deg);

/// Returns the equal angle in (-180, 180].
[[nodiscard]] double Wrap180(double angle_deg);

/// Returns the unit vector (x East, y North) that points along a compass heading.
[[nodiscard]] Eigen::Vector2d UnitVector(double heading_rad);

/// Returns the compass heading of `vector`, [0, 2 pi); 0 for a vector without length.
[[nodiscard]] double HeadingOf(const Eigen::Vector2d& vector);

/// Returns psi, (-pi, pi], of a compass heading.
[[nodiscard]] double PsiFromHeading(double heading_rad);

/// Returns the compass heading, [0, 2 pi), of a psi.
[[nodiscard]] double HeadingFromPsi(double psi_rad);

}  // namespace shoal
