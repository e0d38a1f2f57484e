#include "lib/helm/behaviors/obstacle_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/contact_recipe.h"
#include "lib/helm/decision/domain.h"

namespace shoal {

namespace {

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double DistanceToSegment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Eigen::Vector2d& point) {
  const Eigen::Vector2d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double along = length2 > 0 ? std::clamp((point - a).dot(edge) / length2, 0.0, 1.0) : 0;
  return (a + along * edge - point).norm();
}

/// Touching is left to the distances.
bool Intersect(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
               const Eigen::Vector2d& d) {
  return Cross(b - a, c - a) * Cross(b - a, d - a) < 0 &&
         Cross(d - c, a - c) * Cross(d - c, b - c) < 0;
}

/// Of a segment and the edges of a polygon; 0 where they intersect.
double DistanceToEdges(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                       const std::vector<Eigen::Vector2d>& polygon_m) {
  double distance_m = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    const Eigen::Vector2d& c = polygon_m[i];
    const Eigen::Vector2d& d = polygon_m[(i + 1) % polygon_m.size()];
    if (Intersect(a, b, c, d)) return 0;
    distance_m = std::min({distance_m, DistanceToSegment(a, b, c), DistanceToSegment(c, d, a),
                           DistanceToSegment(c, d, b)});
  }
  return distance_m;
}

/// Where a turn is, and how close to the obstacle it has been.
struct Turn {
  Eigen::Vector2d position_m;
  double turned_deg = 0;
  double clearance_m = 0;
};

Turn TurnBy(double turned_deg, int side, const Turn& from, const VesselMotion& own, double radius_m,
            const std::vector<Eigen::Vector2d>& polygon_m) {
  Turn turn = {
      .position_m = from.position_m, .turned_deg = turned_deg, .clearance_m = from.clearance_m};
  if (radius_m <= 0) return turn;
  const double heading_rad = DegToRad(own.heading_deg);
  const Eigen::Vector2d outward = UnitVector(heading_rad - side * kPi / 2);
  const Eigen::Vector2d centre_m = own.position_m - radius_m * outward;
  turn.position_m =
      centre_m + radius_m * UnitVector(heading_rad - side * kPi / 2 + side * DegToRad(turned_deg));
  turn.clearance_m =
      std::min(turn.clearance_m, DistanceToEdges(from.position_m, turn.position_m, polygon_m));
  return turn;
}

}  // namespace

std::vector<double> ClearanceOfCourses(const VesselMotion& own, const TurnThenStraight& path,
                                       const std::vector<Eigen::Vector2d>& polygon_m) {
  SHOAL_CHECK(polygon_m.size() >= 3, "a polygon has three corners");
  std::vector<double> clearance_m(Domain::kNumCourses, 0.0);
  const double here_m = DistanceTo(polygon_m, own.position_m);
  if (here_m <= 0) return clearance_m;
  for (const int side : {1, -1}) {
    // The courses on this side, by growing turn: each goes on from where the last one turned to.
    Turn turn = {.position_m = own.position_m, .clearance_m = here_m};
    double turned_deg = side > 0 ? std::ceil(own.heading_deg) - own.heading_deg
                                 : own.heading_deg - std::floor(own.heading_deg);
    while (turned_deg <= 180) {
      turn = TurnBy(turned_deg, side, turn, own, path.turn_radius_m, polygon_m);
      const double course_deg = Wrap360(own.heading_deg + side * turned_deg);
      const auto course = static_cast<size_t>(std::lround(course_deg)) % clearance_m.size();
      const Eigen::Vector2d end_m =
          turn.position_m + path.reach_m * UnitVector(DegToRad(course_deg));
      const double ray_m = DistanceToEdges(turn.position_m, end_m, polygon_m);
      clearance_m[course] = std::max(clearance_m[course], std::min(turn.clearance_m, ray_m));
      turned_deg += 1;
    }
  }
  return clearance_m;
}

}  // namespace shoal
