#include "lib/sea/rays/traced_eigenrays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/sea/rays/traced_ray.h"

namespace shoal {

namespace {

/// Of the launch fan before it is refined. Two rays of one history that are as near have at most
/// one fold of the family between them.
constexpr double kFanStep_rad = 0.02;
/// Histories that are narrower than this are not looked for.
constexpr double kNarrowest_rad = 1e-9;
/// In an interval no wider than this the depth changes by at most kSlopeMargin times the slope at
/// either end.
constexpr double kSmooth_rad = 2e-3;
constexpr double kSlopeMargin = 5;
constexpr double kKinkMargin = 40;
constexpr int kMaxSolverSteps = 60;
constexpr double kDepthTolerance_m = 1e-10;

struct Shot {
  double launch_rad = 0;
  TracedRay ray;
};

bool HaveOnePath(const Shot& a, const Shot& b) {
  return a.ray.arrived && b.ray.arrived && a.ray.history == b.ray.history;
}

/// Between rays that turned in other layers the depth is continuous, but its slope is not.
bool IsOneHistory(const Shot& a, const Shot& b) {
  return HaveOnePath(a, b) && a.ray.turns == b.ray.turns;
}

class FanSearch {
 public:
  FanSearch(const RayScene& scene, const SectionPoint& source, const SectionPoint& receiver,
            const RayLimits& limits)
      : scene_(scene), source_(source), receiver_(receiver), limits_(limits), tracer_(scene) {}

  std::vector<RayArrival> Run() {
    const int steps =
        std::max(2, static_cast<int>(std::ceil(2 * limits_.max_launch_rad / kFanStep_rad)));
    Shot before = Shoot(-limits_.max_launch_rad);
    for (int i = 1; i <= steps; ++i) {
      const Shot after = Shoot(limits_.max_launch_rad * (2.0 * i / steps - 1));
      Search(before, after);
      before = after;
    }
    return std::move(arrivals_);
  }

 private:
  Shot Shoot(double launch_rad) const {
    return {launch_rad, tracer_.Trace(source_, receiver_.range_m, launch_rad, limits_)};
  }
  double AboveOf(const Shot& shot) const { return shot.ray.depth_m - receiver_.depth_m; }

  void Search(const Shot& a, const Shot& b) {
    if (!a.ray.arrived && !b.ray.arrived && b.launch_rad - a.launch_rad < kSmooth_rad) return;
    if (!IsOneHistory(a, b)) {
      if (b.launch_rad - a.launch_rad > kNarrowest_rad && (MayCross(a, b) || MayCross(b, a))) {
        Split(a, b);
      }
      return;
    }
    const double above_a = AboveOf(a);
    const double above_b = AboveOf(b);
    if ((above_a < 0) != (above_b < 0)) return Refine(a, b);
    const double sign = above_a < 0 ? -1 : 1;
    const double slope_a = sign * a.ray.depth_slope_m;
    const double slope_b = sign * b.ray.depth_slope_m;
    if (!(slope_a < 0 && slope_b > 0)) return;
    const double width = b.launch_rad - a.launch_rad;
    const double high_a = std::abs(above_a);
    const double high_b = std::abs(above_b);
    const double meet = (high_b - high_a - slope_b * width) / (slope_a - slope_b);
    const double lowest = high_a + slope_a * std::clamp(meet, 0.0, width);
    if (2 * lowest - std::min(high_a, high_b) > 0) return;
    SearchFold(a, b);
  }

  /// Whether the rays next to `a`, of its history, may come to the receiver's depth before those of
  /// `b` begin.
  bool MayCross(const Shot& a, const Shot& b) const {
    const double width = std::abs(b.launch_rad - a.launch_rad);
    if (width > kSmooth_rad && !HaveOnePath(a, b)) return true;
    // A ray that is horizontal at a kink of the profile has a slope without bound.
    const double margin = HaveOnePath(a, b) ? kKinkMargin : kSlopeMargin;
    return a.ray.arrived && std::abs(AboveOf(a)) <= margin * std::abs(a.ray.depth_slope_m) * width;
  }

  void Split(const Shot& a, const Shot& b) {
    const Shot middle = Shoot((a.launch_rad + b.launch_rad) / 2);
    Search(a, middle);
    Search(middle, b);
  }

  /// Both are on one side of the receiver, and the family folds between them.
  void SearchFold(Shot a, Shot b) {
    const Shot first = a;
    const Shot last = b;
    const bool falls = a.ray.depth_slope_m < 0;
    while (b.launch_rad - a.launch_rad > kNarrowest_rad) {
      const Shot middle = Shoot((a.launch_rad + b.launch_rad) / 2);
      if (!IsOneHistory(a, middle)) return Split(a, b);
      if ((AboveOf(middle) < 0) != (AboveOf(a) < 0)) {
        Refine(first, middle);
        return Refine(middle, last);
      }
      ((middle.ray.depth_slope_m < 0) == falls ? a : b) = middle;
    }
  }

  /// Newton's method within a bracket.
  void Refine(Shot a, Shot b) {
    const bool a_is_above = AboveOf(a) < 0;
    Shot shot = Shoot((a.launch_rad + b.launch_rad) / 2);
    for (int i = 0; i < kMaxSolverSteps; ++i) {
      if (!IsOneHistory(a, shot) || !IsOneHistory(shot, b)) {
        if (b.launch_rad - a.launch_rad <= kNarrowest_rad) return;
        Search(a, shot);
        return Search(shot, b);
      }
      const double above_m = AboveOf(shot);
      ((above_m < 0) == a_is_above ? a : b) = shot;
      double next_rad = shot.launch_rad - above_m / shot.ray.depth_slope_m;
      if (!(next_rad > a.launch_rad && next_rad < b.launch_rad)) {
        next_rad = (a.launch_rad + b.launch_rad) / 2;
      }
      if (std::abs(above_m) <= kDepthTolerance_m || next_rad == shot.launch_rad ||
          next_rad == a.launch_rad || next_rad == b.launch_rad) {
        break;
      }
      shot = Shoot(next_rad);
    }
    AddArrival(shot);
  }

  void AddArrival(const Shot& shot) {
    const TracedRay& ray = shot.ray;
    if (ray.reflection < limits_.min_reflection) return;
    const double c_source = SpeedAt(scene_, source_.range_m, source_.depth_m);
    const double c_receiver = SpeedAt(scene_, receiver_.range_m, receiver_.depth_m);
    const double range_m = receiver_.range_m - source_.range_m;
    RayArrival arrival;
    // What the root lacks in depth, along the wave front's slowness.
    arrival.delay_s =
        ray.delay_s + Sin(ray.arrive_rad) / c_receiver * (receiver_.depth_m - ray.depth_m);
    arrival.launch_rad = shot.launch_rad;
    arrival.arrive_rad = ray.arrive_rad;
    arrival.num_surface = ray.num_surface;
    arrival.num_bottom = ray.num_bottom;
    arrival.num_caustics = ray.num_caustics;
    arrival.reflection = ray.reflection;
    arrival.length_m = ray.length_m;
    arrival.spread_m = std::abs(ray.depth_slope_m);
    arrival.amplitude =
        ray.reflection *
        std::sqrt(c_receiver * Cos(shot.launch_rad) /
                  (c_source * range_m * std::max(arrival.spread_m, 1e-300) * Cos(ray.arrive_rad)));
    arrival.phase_rad = WrappedPhase(ray.phase_rad);
    arrivals_.push_back(arrival);
  }

  const RayScene& scene_;
  const SectionPoint source_;
  const SectionPoint receiver_;
  const RayLimits& limits_;
  RayTracer tracer_;
  std::vector<RayArrival> arrivals_;
};

}  // namespace

std::vector<RayArrival> FindTracedRays(const RayScene& scene, const SectionPoint& source,
                                       const SectionPoint& receiver, const RayLimits& limits) {
  return FanSearch(scene, source, receiver, limits).Run();
}

}  // namespace shoal
