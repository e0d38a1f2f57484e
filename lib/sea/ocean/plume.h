// Pollution that leaks from a point for so long that it changes no more.
#pragma once

#include <Eigen/Core>

namespace shoal {

struct Plume {
  Eigen::Vector3d source_m = {0, 0, 30};  ///< x East, y North, z down.
  double rate_gps = 1.59;                 ///< Grams per second.
  double current_mps = 1.5;               ///< Below kMinPlumeCurrent_mps counts as that.
  double direction_rad = 0;               ///< psi, toward which the current flows.
  double floor_z_m = 125;
};

/// In still water a plume that changes no more would be endless.
inline constexpr double kMinPlumeCurrent_mps = 0.1;

/// Returns whether a plume can be made of these: finite numbers, 0 <= rate <= 1e9, 0 <= current <=
/// 50, coordinates within +-1e9.
[[nodiscard]] bool IsPlume(const Plume& plume);

/// Returns the concentration in g/m^3, >= 0. With x along the current from the source and y across:
///
///   c = Q / (2 pi u s_y s_z) e^(-y^2 / (2 s_y^2)) (e^(-(z - h)^2 / (2 s_z^2))
///                                                  + e^(-(z + h)^2 / (2 s_z^2)))
///
/// the steady Gaussian plume that the surface throws back and the floor does not (J. M. Stockie,
/// "The mathematics of atmospheric dispersion modeling", SIAM Review 53 (2011), section 3), with
/// MuNet's s_y = 1.36 x^0.82, s_z = 0.275 x^0.69 and rising plume h = z_source - 2.126e-4 x^(2/3)
/// (golden pollution_plume.csv). Nearer than 1 cm, x counts as that. Zero up the current, above the
/// surface and below the floor. @pre IsPlume(plume), position finite
[[nodiscard]] double Concentration(const Plume& plume, const Eigen::Vector3d& position_m);

}  // namespace shoal
