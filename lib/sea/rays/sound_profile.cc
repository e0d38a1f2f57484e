#include "lib/sea/rays/sound_profile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/text/numbers.h"
#include "lib/sea/ocean/sound_speed.h"

namespace shoal {

namespace {

std::string PlaceText(size_t index, const SpeedPoint& point) {
  return "point " + std::to_string(index + 1) + " (depth " + ShortestText(point.depth_m) +
         " m, speed " + ShortestText(point.speed_mps) + " m/s)";
}

/// Time to cross `height_m` of water in which the speed goes evenly from one value to the other.
double CrossingTime(double height_m, double speed_a_mps, double speed_b_mps) {
  const double relative = (speed_b_mps - speed_a_mps) / speed_a_mps;
  if (std::abs(relative) < 1e-6) return height_m / speed_a_mps * (1 - relative / 2);
  return height_m * Log1p(relative) / (speed_b_mps - speed_a_mps);
}

}  // namespace

Result<SoundProfile> SoundProfile::Make(std::vector<SpeedPoint> points) {
  if (points.empty()) return Error{"a sound speed profile needs at least one point"};
  if (points.size() > kMaxProfilePoints) {
    return Error{"a sound speed profile has at most " + std::to_string(kMaxProfilePoints) +
                 " points, not " + std::to_string(points.size())};
  }
  for (size_t i = 0; i < points.size(); ++i) {
    if (!IsBetween(points[i].depth_m, 0, kMaxProfileDepth_m)) {
      return Error{PlaceText(i, points[i]) + ": the depth must be between 0 and " +
                   ShortestText(kMaxProfileDepth_m) + " m"};
    }
    if (!IsBetween(points[i].speed_mps, kMinRaySpeed_mps, kMaxRaySpeed_mps)) {
      return Error{PlaceText(i, points[i]) + ": the speed must be between " +
                   ShortestText(kMinRaySpeed_mps) + " and " + ShortestText(kMaxRaySpeed_mps) +
                   " m/s"};
    }
    if (i > 0 && !(points[i].depth_m > points[i - 1].depth_m)) {
      return Error{PlaceText(i, points[i]) + ": depths must grow from point to point"};
    }
  }
  SoundProfile profile;
  profile.points_ = std::move(points);
  return profile;
}

double SoundProfile::SpeedAt(double depth_m) const {
  const auto above = std::ranges::upper_bound(points_, depth_m, {}, &SpeedPoint::depth_m);
  if (above == points_.begin()) return points_.front().speed_mps;
  if (above == points_.end()) return points_.back().speed_mps;
  const SpeedPoint& a = *std::prev(above);
  const SpeedPoint& b = *above;
  return a.speed_mps +
         (b.speed_mps - a.speed_mps) * ((depth_m - a.depth_m) / (b.depth_m - a.depth_m));
}

double SoundProfile::MeanSpeed(double depth_a_m, double depth_b_m) const {
  const double top_m = std::min(depth_a_m, depth_b_m);
  const double bottom_m = std::max(depth_a_m, depth_b_m);
  if (!(bottom_m > top_m)) return SpeedAt(top_m);
  double time_s = 0;
  double depth_m = top_m;
  const auto cross_to = [&](double next_m) {
    time_s += CrossingTime(next_m - depth_m, SpeedAt(depth_m), SpeedAt(next_m));
    depth_m = next_m;
  };
  for (const SpeedPoint& point : points_) {
    if (point.depth_m > depth_m && point.depth_m < bottom_m) cross_to(point.depth_m);
  }
  cross_to(bottom_m);
  return (bottom_m - top_m) / time_s;
}

bool SoundProfile::is_constant() const {
  return std::ranges::all_of(points_, [this](const SpeedPoint& point) {
    return point.speed_mps == points_.front().speed_mps;
  });
}

Result<SoundProfile> MunkProfile(const MunkShape& shape, double depth_m, double step_m) {
  if (!(shape.scale_m > 0)) return Error{"scale_m of a Munk profile must be more than 0"};
  if (!(step_m > 0 && IsBetween(depth_m, step_m, kMaxProfileDepth_m))) {
    return Error{"a Munk profile needs 0 < step_m <= depth_m <= " +
                 ShortestText(kMaxProfileDepth_m)};
  }
  const double count = std::ceil(depth_m / step_m);
  if (!(count < kMaxProfilePoints)) {
    return Error{"a Munk profile with more than 10000 points: raise step_m above " +
                 ShortestText(depth_m / (kMaxProfilePoints - 1))};
  }
  std::vector<SpeedPoint> points;
  for (double i = 0; i <= count; ++i) {
    const double z_m = depth_m * (i / count);
    const double eta = 2 * (z_m - shape.axis_depth_m) / shape.scale_m;
    points.push_back(
        {z_m, shape.axis_speed_mps * (1 + shape.perturbation * (eta + Exp(-eta) - 1))});
  }
  return SoundProfile::Make(std::move(points));
}

Result<SoundProfile> ProfileOfCast(std::span<const CastPoint> cast) {
  std::vector<SpeedPoint> points;
  for (const CastPoint& point : cast) {
    const std::optional<double> speed_mps = SoundSpeed({.temperature_degc = point.temperature_degc,
                                                        .salinity_ppt = point.salinity_ppt,
                                                        .depth_m = point.depth_m});
    if (!speed_mps) {
      return Error{"point " + std::to_string(points.size() + 1) + " (depth " +
                   ShortestText(point.depth_m) + " m, " + ShortestText(point.temperature_degc) +
                   " degC, " + ShortestText(point.salinity_ppt) +
                   " ppt) is outside Mackenzie's equation: " + ShortestText(kMinTemperature_degc) +
                   " to " + ShortestText(kMaxTemperature_degc) + " degC, " +
                   ShortestText(kMinSalinityForSoundSpeed_ppt) + " to " +
                   ShortestText(kMaxSalinity_ppt) + " ppt, 0 to " + ShortestText(kMaxDepth_m) +
                   " m"};
    }
    points.push_back({point.depth_m, *speed_mps});
  }
  return SoundProfile::Make(std::move(points));
}

}  // namespace shoal
