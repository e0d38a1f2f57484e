#include "lib/helm/behaviors/stay_inside.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kRounding_m = 1e-7;

/// An edge, as seen from the vessel.
struct Edge {
  double outward_rad = 0;  ///< The bearing in which it is nearest.
  double room_m = 0;       ///< How far it is in that direction; negative: the vessel is outside.
};

std::vector<Edge> EdgesOf(const Polygon& polygon_m, const Eigen::Vector2d& position_m) {
  const double outward = IsClockwise(polygon_m) ? 1 : -1;
  std::vector<Edge> edges;
  edges.reserve(polygon_m.size());
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    const Eigen::Vector2d along_m = polygon_m[(i + 1) % polygon_m.size()] - polygon_m[i];
    const double length_m = along_m.norm();
    if (length_m == 0) continue;
    const Eigen::Vector2d normal = outward / length_m * Eigen::Vector2d(-along_m.y(), along_m.x());
    edges.push_back({.outward_rad = HeadingOf(normal),
                     .room_m = normal.dot(polygon_m[i] - position_m) + kRounding_m});
  }
  return edges;
}

/// Returns how far toward an edge the turn to a course, and the course after it, get at unit speed.
double Reach(double outward_rad, double heading_rad, double turn_rad, const LookAhead& ahead) {
  const double rate_radps = std::copysign(DegToRad(ahead.turn_degps), turn_rad);
  const double turn_s = std::min(turn_rad / rate_radps, ahead.horizon_s);
  const double from_rad = heading_rad - outward_rad;
  const auto reach_in_turn = [&](double time_s) {
    return (Sin(from_rad + rate_radps * time_s) - Sin(from_rad)) / rate_radps;
  };
  const double after_turn = reach_in_turn(turn_s);
  const double at_end = after_turn + (ahead.horizon_s - turn_s) * Cos(from_rad + turn_rad);
  double farthest = std::max({0.0, after_turn, at_end});
  // Within the turn it is nearest to the edge where it goes along it.
  const double along_s =
      WrapTwoPi(std::copysign(1.0, turn_rad) * (std::copysign(kPi / 2, turn_rad) - from_rad)) /
      std::abs(rate_radps);
  if (along_s < turn_s) farthest = std::max(farthest, reach_in_turn(along_s));
  return farthest;
}

/// Speeds of one course that keep the vessel inside, or take it there.
struct SpeedLimits {
  double least_mps = 0;
  double most_mps = std::numeric_limits<double>::infinity();
};

SpeedLimits LimitsOf(const std::vector<Edge>& edges, const VesselMotion& own, int course,
                     const LookAhead& ahead, bool is_inside) {
  constexpr SpeedLimits kNone = {.least_mps = 1, .most_mps = 0};
  SpeedLimits limits;
  const double turn_rad = DegToRad(Wrap180(course - own.heading_deg));
  for (const Edge& edge : edges) {
    double reach = ahead.horizon_s * Cos(DegToRad(course) - edge.outward_rad);
    if (std::abs(reach) < 1e-9) reach = 0;
    if (is_inside && ahead.turn_degps > 0 && turn_rad != 0) {
      reach = std::max(reach, Reach(edge.outward_rad, DegToRad(own.heading_deg), turn_rad, ahead));
    }
    if (reach > 0) {
      limits.most_mps = std::min(limits.most_mps, edge.room_m / reach);
    } else if (reach < 0) {
      limits.least_mps = std::max(limits.least_mps, edge.room_m / reach);
    } else if (edge.room_m < 0) {
      return kNone;
    }
  }
  return limits;
}

IndexRange Within(const SpeedLimits& limits, const Axis& speeds_mps) {
  const auto index_of = [&](double speed_mps) {
    return (speed_mps - speeds_mps.first) / speeds_mps.step;
  };
  const double first = std::ceil(std::max(index_of(limits.least_mps), 0.0));
  const double last = std::floor(std::min(index_of(limits.most_mps), speeds_mps.count - 1.0));
  if (last < first) return {};
  return {.first = static_cast<int>(first), .last = static_cast<int>(last)};
}

}  // namespace

AllowedPart StayInside(const Polygon& polygon_m, const VesselMotion& own, const LookAhead& ahead,
                       const Domain& domain) {
  if (domain.speed_mps.count == 0) return {};
  std::vector<Edge> edges = EdgesOf(polygon_m, own.position_m);
  const bool is_inside =
      std::all_of(edges.begin(), edges.end(), [](const Edge& edge) { return edge.room_m >= 0; });
  const double farthest_m = domain.speed_mps.Last() * ahead.horizon_s;
  std::erase_if(edges, [&](const Edge& edge) { return edge.room_m >= farthest_m; });
  if (edges.empty()) return {};
  AllowedPart allowed;
  allowed.speeds.reserve(Domain::kNumCourses);
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    allowed.speeds.push_back(
        Within(LimitsOf(edges, own, course, ahead, is_inside), domain.speed_mps));
  }
  return allowed;
}

}  // namespace shoal
