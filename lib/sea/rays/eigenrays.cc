#include "lib/sea/rays/eigenrays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/check/check.h"
#include "lib/sea/rays/layered_rays.h"
#include "lib/sea/rays/traced_eigenrays.h"

namespace shoal {

namespace {

void MirrorRanges(std::vector<BoundaryPoint>* boundary) {
  std::ranges::reverse(*boundary);
  for (BoundaryPoint& point : *boundary) point.range_m = -point.range_m;
}

RayScene Mirrored(RayScene scene) {
  MirrorRanges(&scene.surface);
  MirrorRanges(&scene.bottom);
  std::ranges::reverse(scene.water);
  for (ProfileAtRange& each : scene.water) each.range_m = -each.range_m;
  return scene;
}

bool IsInWater(const RayScene& scene, const SectionPoint& point) {
  return IsBetween(point.depth_m, DepthAt(scene.surface, point.range_m),
                   DepthAt(scene.bottom, point.range_m));
}

}  // namespace

double WrappedPhase(double phase_rad) {
  const double wrapped = std::remainder(phase_rad, 2 * std::numbers::pi);
  return wrapped <= -std::numbers::pi * (1 - 1e-12) ? wrapped + 2 * std::numbers::pi : wrapped;
}

double PowerOf(const RayArrival& arrival, double absorption_dbpkm) {
  const double lost_db = absorption_dbpkm * arrival.length_m / 1000;
  return arrival.amplitude * arrival.amplitude * Pow(10, -lost_db / 10);
}

std::vector<RayArrival> FindEigenrays(const RayScene& scene, const SectionPoint& source,
                                      const SectionPoint& receiver, const RayLimits& limits) {
  SHOAL_CHECK(limits.max_launch_rad > 0 && limits.max_launch_rad < std::numbers::pi / 2,
              "0 < max_launch_rad < pi/2");
  if (!IsInWater(scene, source) || !IsInWater(scene, receiver)) return {};
  if (source.range_m == receiver.range_m) return {};
  if (receiver.range_m < source.range_m && !IsLayered(scene)) {
    return FindEigenrays(Mirrored(scene), {-source.range_m, source.depth_m},
                         {-receiver.range_m, receiver.depth_m}, limits);
  }
  std::vector<RayArrival> arrivals;
  if (IsLayered(scene)) {
    const double range_m = std::abs(receiver.range_m - source.range_m);
    arrivals = FindLayeredRays(scene, {0, source.depth_m}, {range_m, receiver.depth_m}, limits);
  } else {
    arrivals = FindTracedRays(scene, source, receiver, limits);
  }
  std::ranges::sort(arrivals, [](const RayArrival& a, const RayArrival& b) {
    return a.delay_s != b.delay_s ? a.delay_s < b.delay_s : a.launch_rad < b.launch_rad;
  });
  return arrivals;
}

}  // namespace shoal
