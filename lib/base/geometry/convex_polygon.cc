#include "lib/base/geometry/convex_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kArcStep_rad = DegToRad(15);

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

const Eigen::Vector2d& Corner(const Polygon& polygon_m, size_t index) {
  return polygon_m[index % polygon_m.size()];
}

// Positive for corners that go counter-clockwise.
double TwiceTheArea(const Polygon& polygon_m) {
  double sum = 0;
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    sum += Cross(polygon_m[i] - polygon_m[0], Corner(polygon_m, i + 1) - polygon_m[0]);
  }
  return sum;
}

double DistanceToEdge(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
                      const Eigen::Vector2d& position_m) {
  const Eigen::Vector2d edge_m = to_m - from_m;
  const double square = edge_m.squaredNorm();
  const double part =
      square > 0 ? std::clamp((position_m - from_m).dot(edge_m) / square, 0.0, 1.0) : 0;
  return (from_m + part * edge_m - position_m).norm();
}

}  // namespace

bool IsClockwise(const Polygon& polygon_m) { return TwiceTheArea(polygon_m) < 0; }

bool IsConvex(const Polygon& polygon_m) {
  if (polygon_m.size() < 3) return false;
  const double side = IsClockwise(polygon_m) ? -1 : 1;
  double turned_rad = 0;
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    const Eigen::Vector2d in = Corner(polygon_m, i + 1) - polygon_m[i];
    const Eigen::Vector2d out = Corner(polygon_m, i + 2) - Corner(polygon_m, i + 1);
    const double turn_rad = Atan2(side * Cross(in, out), in.dot(out));
    if (!(turn_rad > -1e-9) || in.norm() == 0) return false;
    turned_rad += turn_rad;
  }
  return std::abs(turned_rad - 2 * kPi) < 1e-6;
}

double SignedDistance(const Polygon& polygon_m, const Eigen::Vector2d& position_m) {
  double least_m = std::numeric_limits<double>::infinity();
  bool is_inside = polygon_m.size() >= 3;
  const double side = IsClockwise(polygon_m) ? -1 : 1;
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    const Eigen::Vector2d& from_m = polygon_m[i];
    const Eigen::Vector2d& to_m = Corner(polygon_m, i + 1);
    least_m = std::min(least_m, DistanceToEdge(from_m, to_m, position_m));
    is_inside = is_inside && side * Cross(to_m - from_m, position_m - from_m) >= 0;
  }
  return is_inside ? -least_m : least_m;
}

Eigen::Vector2d Centroid(const Polygon& polygon_m) {
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    const Eigen::Vector2d a = polygon_m[i] - polygon_m[0];
    const Eigen::Vector2d b = Corner(polygon_m, i + 1) - polygon_m[0];
    weighted += Cross(a, b) / 3 * (a + b);
    sum += a;
  }
  const double area = TwiceTheArea(polygon_m);
  const bool is_flat = std::abs(area) < 1e-9;
  return polygon_m[0] + (is_flat ? Eigen::Vector2d(sum / static_cast<double>(polygon_m.size()))
                                 : Eigen::Vector2d(weighted / area));
}

Polygon Grown(const Polygon& polygon_m, double distance_m) {
  Polygon clockwise_m = polygon_m;
  if (!IsClockwise(clockwise_m)) std::reverse(clockwise_m.begin(), clockwise_m.end());
  if (distance_m == 0) return clockwise_m;
  Polygon grown_m;
  const size_t size = clockwise_m.size();
  for (size_t i = 0; i < size; ++i) {
    // Outward of a clockwise edge is to port.
    const Eigen::Vector2d& corner_m = clockwise_m[i];
    const double in_rad = HeadingOf(corner_m - Corner(clockwise_m, i + size - 1)) - kPi / 2;
    const double out_rad = HeadingOf(Corner(clockwise_m, i + 1) - corner_m) - kPi / 2;
    const double arc_rad = WrapTwoPi(out_rad - in_rad);
    const int steps = static_cast<int>(std::max(1.0, std::ceil(arc_rad / kArcStep_rad - 1e-9)));
    for (int step = 0; step <= steps; ++step) {
      grown_m.emplace_back(corner_m + distance_m * UnitVector(in_rad + arc_rad * step / steps));
    }
  }
  return grown_m;
}

std::optional<double> RayDistance(const Polygon& polygon_m, const Eigen::Vector2d& position_m,
                                  double heading_rad) {
  const Eigen::Vector2d ahead = UnitVector(heading_rad);
  std::optional<double> nearest_m;
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    const Eigen::Vector2d edge_m = Corner(polygon_m, i + 1) - polygon_m[i];
    const Eigen::Vector2d offset_m = polygon_m[i] - position_m;
    const double slope = Cross(ahead, edge_m);
    if (slope == 0) continue;  // Alongside: the edges that follow and precede it are hit instead.
    const double distance_m = Cross(offset_m, edge_m) / slope;
    const double part = Cross(offset_m, ahead) / slope;
    if (distance_m < 0 || part < 0 || part > 1) continue;
    nearest_m = std::min(nearest_m.value_or(distance_m), distance_m);
  }
  return nearest_m;
}

}  // namespace shoal
