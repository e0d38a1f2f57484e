#include "lib/behaviors/stay_inside.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lib/geometry/angles.h"

namespace shoal {

namespace {

/// An edge as the half of the plane on its inner side: normal.dot(step) <= room_m for a
/// step from the position.
struct Edge {
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< Of length 1, outward.
  double room_m = 0;                                 ///< From the position to the edge.
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
    edges.push_back({.normal = normal, .room_m = normal.dot(polygon_m[i] - position_m)});
  }
  return edges;
}

/// Returns the speeds, as indices, that take the vessel inside all edges.
IndexRange SpeedsInside(const std::vector<Edge>& edges, const Eigen::Vector2d& ahead,
                        double horizon_s, const Axis& speeds_mps) {
  constexpr double kRounding_m = 1e-7;
  double least_m = 0;
  double most_m = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges) {
    const double slope = edge.normal.dot(ahead);
    const double room_m = edge.room_m + kRounding_m;
    if (slope > 0) {
      most_m = std::min(most_m, room_m / slope);
    } else if (slope < 0) {
      least_m = std::max(least_m, room_m / slope);
    } else if (room_m < 0) {
      return {};
    }
  }
  const auto index_of = [&](double distance_m) {
    return (distance_m / horizon_s - speeds_mps.first) / speeds_mps.step;
  };
  const double first = std::ceil(std::max(index_of(least_m), 0.0));
  const double last = std::floor(std::min(index_of(most_m), speeds_mps.count - 1.0));
  if (last < first) return {};
  return {.first = static_cast<int>(first), .last = static_cast<int>(last)};
}

}  // namespace

Allowed StayInside(const Polygon& polygon_m, const Eigen::Vector2d& position_m, double horizon_s,
                   const Domain& domain) {
  if (domain.speed_mps.count == 0) return {};
  const std::vector<Edge> edges = EdgesOf(polygon_m, position_m);
  const double farthest_m = domain.speed_mps.Last() * horizon_s;
  const bool is_far = std::all_of(edges.begin(), edges.end(),
                                  [&](const Edge& edge) { return edge.room_m >= farthest_m; });
  if (is_far) return {};
  Allowed allowed;
  allowed.speeds.reserve(Domain::kNumCourses);
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    allowed.speeds.push_back(
        SpeedsInside(edges, UnitVector(DegToRad(course)), horizon_s, domain.speed_mps));
  }
  return allowed;
}

}  // namespace shoal
