#include "lib/vehicle/vehicle/attitude.h"

#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kMinCosPitch = 1e-3;

}  // namespace

Eigen::Matrix3d BodyToWorld(double phi_rad, double theta_rad, double psi_rad) {
  const auto [sphi, cphi] = SinCos(phi_rad);
  const auto [sth, cth] = SinCos(theta_rad);
  const auto [spsi, cpsi] = SinCos(psi_rad);
  Eigen::Matrix3d rotation;
  rotation << cpsi * cth, -spsi * cphi + cpsi * sth * sphi, spsi * sphi + cpsi * cphi * sth,  //
      spsi * cth, cpsi * cphi + sphi * sth * spsi, -cpsi * sphi + sth * spsi * cphi,          //
      -sth, cth * sphi, cth * cphi;
  return rotation;
}

Eigen::Matrix3d BodyRatesToEulerRates(double phi_rad, double theta_rad) {
  const auto [sphi, cphi] = SinCos(phi_rad);
  auto [sth, cth] = SinCos(theta_rad);
  if (std::abs(cth) < kMinCosPitch) cth = std::copysign(kMinCosPitch, cth);
  Eigen::Matrix3d rates;
  rates << 1, sphi * sth / cth, cphi * sth / cth,  //
      0, cphi, -sphi,                              //
      0, sphi / cth, cphi / cth;
  return rates;
}

Eigen::Vector3d NormalizeEuler(const Eigen::Vector3d& angles_rad) {
  const bool is_normal = std::abs(angles_rad[0]) < kPi && std::abs(angles_rad[1]) <= kPi / 2 &&
                         std::abs(angles_rad[2]) < kPi;
  if (is_normal) return angles_rad;  // Nearly always, and std::remainder is slow.
  double phi = angles_rad[0];
  double theta = WrapPi(angles_rad[1]);
  double psi = angles_rad[2];
  if (std::abs(theta) > kPi / 2) {
    theta = std::copysign(kPi, theta) - theta;
    phi = WrapPi(phi) + kPi;
    psi = WrapPi(psi) + kPi;
  }
  return {WrapPi(phi), theta, WrapPi(psi)};
}

}  // namespace shoal
