#include "lib/vehicle/sensors/forward_looking_sonar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/vehicle/vehicle/attitude.h"

namespace shoal {

namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

/// Positions count as no further away than this: squares stay finite.
constexpr double kMaxCoordinate_m = 1e12;

/// False for NaN.
bool IsBetween(double value, double low, double high) { return value >= low && value <= high; }

/// Returns angle `index` of `count` that spread evenly over `width` about `middle`.
double Spread(double middle, double width, int index, int count) {
  return count == 1 ? middle : middle - width / 2 + width * index / (count - 1);
}

Eigen::Vector3d Bounded(const Eigen::Vector3d& position_m) {
  return position_m.cwiseMax(-kMaxCoordinate_m).cwiseMin(kMaxCoordinate_m);
}

double FloorRange(const SonarParams& params, const SeaFloor& floor,
                  const Eigen::Vector3d& position_m, const Eigen::Vector3d& direction) {
  for (int step = 1; step <= params.range_steps; ++step) {
    const double range_m = params.max_range_m * step / params.range_steps;
    const Eigen::Vector3d point_m = position_m + range_m * direction;
    if (floor.DepthAt(point_m.head<2>()) <= point_m.z()) return range_m;
  }
  return kNothing;
}

double TargetRange(const SonarTarget& target, const Eigen::Vector3d& position_m,
                   const Eigen::Vector3d& direction) {
  const Eigen::Vector3d way_m = Bounded(target.position_m) - position_m;
  const double radius_m = std::min(target.radius_m, kMaxCoordinate_m);
  const double beyond_m2 = way_m.squaredNorm() - radius_m * radius_m;
  if (beyond_m2 < 0) return 0;
  const double closest_m = way_m.dot(direction);
  const double half_chord_m2 = closest_m * closest_m - beyond_m2;
  if (closest_m <= 0 || half_chord_m2 <= 0) return kNothing;
  return std::max(0.0, closest_m - std::sqrt(half_chord_m2));
}

/// A beam this near to the vertical meets no wall.
constexpr double kLevelPart = 1e-9;

double WallRange(const Polygon& wall_m, const Eigen::Vector3d& position_m,
                 const Eigen::Vector3d& direction) {
  if (SignedDistance(wall_m, position_m.head<2>()) < 0) return 0;
  const double level = direction.head<2>().norm();
  if (level < kLevelPart) return kNothing;
  const std::optional<double> level_m =
      RayDistance(wall_m, position_m.head<2>(), HeadingOf(direction.head<2>()));
  return level_m ? *level_m / level : kNothing;
}

}  // namespace

bool IsSonar(const SonarParams& params) {
  return IsBetween(params.azimuth_beams, 1, kMaxSonarBeams) &&
         IsBetween(params.elevation_beams, 1, kMaxSonarBeams) &&
         IsBetween(params.range_steps, 1, kMaxRangeSteps) && params.max_range_m > 0 &&
         params.max_range_m <= 1e5 && IsBetween(params.tilt_rad, -kPi, kPi) &&
         IsBetween(params.width_rad, 0, kPi) && IsBetween(params.height_rad, 0, kPi) &&
         params.rate_hz > 0 && std::isfinite(params.rate_hz) &&
         IsBetween(params.range_noise.sigma, 0, 1e5);
}

ForwardLookingSonar::ForwardLookingSonar(const SonarParams& params) : params_(params) {
  SHOAL_CHECK(IsSonar(params), "IsSonar() holds for the parameters");
  for (int i = 0; i < params.azimuth_beams; ++i) {
    const double azimuth = Spread(0, params.width_rad, i, params.azimuth_beams);
    for (int j = 0; j < params.elevation_beams; ++j) {
      const double below = Spread(params.tilt_rad, params.height_rad, j, params.elevation_beams);
      beams_.emplace_back(Cos(azimuth) * Cos(below), Sin(azimuth) * Cos(below), Sin(below));
    }
  }
}

void ForwardLookingSonar::Ping(const SonarPose& pose, const SonarScene& scene, int64_t number,
                               std::span<SonarBeam> beams) const {
  SHOAL_CHECK(beams.size() == beams_.size(), "beams.size() == beam_count()");
  const Eigen::Matrix3d rotation = BodyToWorld(pose.phi_rad, pose.theta_rad, pose.psi_rad);
  const Eigen::Vector3d position_m = Bounded(pose.position_m);
  Stream draws = params_.range_noise.Measurement(number);
  for (size_t i = 0; i < beams.size(); ++i) {
    SonarBeam& beam = beams[i];
    beam.direction = rotation * beams_[i];
    double range_m = FloorRange(params_, scene.floor, position_m, beam.direction);
    for (const SonarTarget& target : scene.vehicles) {
      range_m = std::min(range_m, TargetRange(target, position_m, beam.direction));
    }
    for (const Polygon& wall_m : scene.walls_m) {
      range_m = std::min(range_m, WallRange(wall_m, position_m, beam.direction));
    }
    // Each beam draws, seen or not: what one sees does not change the noise of others.
    const double error_m =
        params_.range_noise.sigma == 0 ? 0 : params_.range_noise.sigma * draws.Normal();
    beam.is_echo = range_m <= params_.max_range_m;
    beam.range_m = beam.is_echo ? std::clamp(range_m + error_m, 0.0, params_.max_range_m)
                                : params_.max_range_m;
  }
}

}  // namespace shoal
