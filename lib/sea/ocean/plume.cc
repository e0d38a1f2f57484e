#include "lib/sea/ocean/plume.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kMinDistance_m = 0.01;
constexpr double kMaxCoordinate_m = 1e9;

bool IsPlace(double coordinate_m) {
  return IsBetween(coordinate_m, -kMaxCoordinate_m, kMaxCoordinate_m);
}

/// Returns e^(-(offset / sigma)^2 / 2).
double Bell(double offset, double sigma) {
  const double deviations = offset / sigma;
  return Exp(-deviations * deviations / 2);
}

}  // namespace

bool IsPlume(const Plume& plume) {
  return IsPlace(plume.source_m.x()) && IsPlace(plume.source_m.y()) &&
         IsPlace(plume.source_m.z()) && IsBetween(plume.rate_gps, 0, 1e9) &&
         IsBetween(plume.current_mps, 0, 50) && std::isfinite(plume.direction_rad) &&
         IsPlace(plume.floor_z_m);
}

double Concentration(const Plume& plume, const Eigen::Vector3d& position_m) {
  SHOAL_CHECK(IsPlume(plume), "IsPlume(plume)");
  const double z = position_m.z();
  if (!IsBetween(z, 0, plume.floor_z_m)) return 0;
  const double east =
      std::clamp(position_m.x(), -2 * kMaxCoordinate_m, 2 * kMaxCoordinate_m) - plume.source_m.x();
  const double north =
      std::clamp(position_m.y(), -2 * kMaxCoordinate_m, 2 * kMaxCoordinate_m) - plume.source_m.y();
  const auto [sine, cosine] = SinCos(plume.direction_rad);
  const double along = east * cosine + north * sine;
  const double across = north * cosine - east * sine;
  if (!(along >= 0)) return 0;
  const double x = std::max(along, kMinDistance_m);
  const double sigma_y = 1.36 * Pow(x, 0.82);
  const double sigma_z = 0.275 * Pow(x, 0.69);
  const double height = plume.source_m.z() - 2.126e-4 * Pow(x, 2.0 / 3);
  const double speed = std::max(plume.current_mps, kMinPlumeCurrent_mps);
  return plume.rate_gps / (2 * kPi * speed * sigma_y * sigma_z) * Bell(across, sigma_y) *
         (Bell(z - height, sigma_z) + Bell(z + height, sigma_z));
}

}  // namespace shoal
