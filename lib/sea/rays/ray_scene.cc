#include "lib/sea/rays/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "lib/base/check/bounds.h"
#include "lib/base/text/numbers.h"

namespace shoal {

namespace {

bool IsFlat(std::span<const BoundaryPoint> boundary) {
  return std::ranges::all_of(boundary, [&](const BoundaryPoint& point) {
    return point.depth_m == boundary.front().depth_m;
  });
}

std::string ProblemOfBoundary(std::string_view name, std::span<const BoundaryPoint> boundary) {
  if (boundary.empty()) return "the " + std::string(name) + " needs at least one point";
  for (size_t i = 0; i < boundary.size(); ++i) {
    const std::string place = std::string(name) + ", point " + std::to_string(i + 1) + ": ";
    if (!std::isfinite(boundary[i].range_m) ||
        !IsBetween(boundary[i].depth_m, -kMaxProfileDepth_m, kMaxProfileDepth_m)) {
      return place + "range and depth must be numbers, the depth within " +
             ShortestText(kMaxProfileDepth_m) + " m";
    }
    if (i > 0 && !(boundary[i].range_m > boundary[i - 1].range_m)) {
      return place + "ranges must grow from point to point";
    }
  }
  return "";
}

/// Between their points both are straight: it is enough to look at these.
bool IsBelow(std::span<const BoundaryPoint> bottom, std::span<const BoundaryPoint> surface) {
  const auto is_water_at = [&](const BoundaryPoint& point) {
    return DepthAt(bottom, point.range_m) > DepthAt(surface, point.range_m);
  };
  return std::ranges::all_of(bottom, is_water_at) && std::ranges::all_of(surface, is_water_at);
}

std::string ProblemOfWater(std::span<const ProfileAtRange> water) {
  if (water.empty()) return "the water needs a sound speed profile";
  for (size_t i = 1; i < water.size(); ++i) {
    if (!(water[i].range_m > water[i - 1].range_m)) {
      return "the ranges of the sound speed profiles must grow";
    }
    if (!std::ranges::equal(water[i].profile.points(), water[0].profile.points(), {},
                            &SpeedPoint::depth_m, &SpeedPoint::depth_m)) {
      return "all sound speed profiles of a section must have the same depths";
    }
  }
  return "";
}

}  // namespace

double DepthAt(std::span<const BoundaryPoint> boundary, double range_m) {
  const auto next = std::ranges::upper_bound(boundary, range_m, {}, &BoundaryPoint::range_m);
  if (next == boundary.begin()) return boundary.front().depth_m;
  if (next == boundary.end()) return boundary.back().depth_m;
  const BoundaryPoint& a = *std::prev(next);
  const double share = (range_m - a.range_m) / (next->range_m - a.range_m);
  return a.depth_m + (next->depth_m - a.depth_m) * share;
}

double SpeedAt(const RayScene& scene, double range_m, double depth_m) {
  const auto next = std::ranges::upper_bound(scene.water, range_m, {}, &ProfileAtRange::range_m);
  if (next == scene.water.begin()) return next->profile.SpeedAt(depth_m);
  const ProfileAtRange& a = *std::prev(next);
  const double near_mps = a.profile.SpeedAt(depth_m);
  if (next == scene.water.end()) return near_mps;
  const double share = (range_m - a.range_m) / (next->range_m - a.range_m);
  return near_mps + (next->profile.SpeedAt(depth_m) - near_mps) * share;
}

bool IsLayered(const RayScene& scene) {
  return scene.water.size() == 1 && IsFlat(scene.surface) && IsFlat(scene.bottom);
}

std::string ProblemOf(const RayScene& scene) {
  std::string problem = ProblemOfWater(scene.water);
  if (problem.empty()) problem = ProblemOfBoundary("surface", scene.surface);
  if (problem.empty()) problem = ProblemOfBoundary("bottom", scene.bottom);
  if (problem.empty() && !IsBelow(scene.bottom, scene.surface)) {
    problem = "the bottom must be below the surface everywhere";
  }
  if (problem.empty() && !(scene.hz > 0 && scene.hz <= 1e7)) {
    problem = "the frequency must be more than 0 and at most 10 MHz";
  }
  if (problem.empty() && !(scene.water_density > 0)) problem = "the water's density must be > 0";
  for (const Reflector* reflector : {&scene.surface_reflector, &scene.bottom_reflector}) {
    const auto* table = std::get_if<ReflectionTable>(reflector);
    if (problem.empty() && table != nullptr) problem = ProblemOf(*table);
    const auto* below = std::get_if<HalfSpace>(reflector);
    if (problem.empty() && below != nullptr &&
        !(IsBetween(below->speed_mps, 1, 20'000) && IsBetween(below->density, 1e-3, 100) &&
          IsBetween(below->attenuation_db_per_wavelength, 0, 100))) {
      problem =
          "a half-space needs a speed from 1 to 20000 m/s, a relative density from 0.001 to "
          "100 and an attenuation from 0 to 100 dB per wavelength";
    }
  }
  return problem;
}

}  // namespace shoal
