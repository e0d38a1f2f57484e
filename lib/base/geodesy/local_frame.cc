#include "lib/base/geodesy/local_frame.h"

#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

bool IsOnEarth(const GeoPoint& point) {
  return std::abs(point.lat_deg) <= 90 && std::abs(point.lon_deg) <= 360;  // False for NaN.
}

bool IsInReach(const Eigen::Vector2d& position_m) {
  return position_m.norm() <= LocalFrame::kReach_m;  // False for NaN.
}

}  // namespace

LocalFrame::LocalFrame(const GeoPoint& origin) : origin_(origin) {
  SHOAL_CHECK(IsOnEarth(origin),
              "the origin has a latitude within +-90 and a longitude within +-180 degrees");
  plane_.Reset(origin.lat_deg, origin.lon_deg, 0);
}

GeoPoint LocalFrame::ToGeo(const Eigen::Vector2d& position_m) const {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (!IsInReach(position_m)) return {.lat_deg = kNan, .lon_deg = kNan};
  GeoPoint point;
  double height_m = 0;
  plane_.Reverse(position_m.x(), position_m.y(), 0, point.lat_deg, point.lon_deg, height_m);
  return point;
}

std::optional<Eigen::Vector2d> LocalFrame::ToLocal(const GeoPoint& point) const {
  if (!IsOnEarth(point)) return std::nullopt;
  Eigen::Vector3d surface_m;
  // Row by row; the third column is the ellipsoid's normal at the point.
  thread_local std::vector<double> rotation(9);
  plane_.Forward(point.lat_deg, point.lon_deg, 0, surface_m.x(), surface_m.y(), surface_m.z(),
                 rotation);
  const Eigen::Vector3d normal(rotation[2], rotation[5], rotation[8]);
  // Far from upright the normal no longer meets the plane within reach.
  if (normal.z() < 0.9) return std::nullopt;
  const Eigen::Vector2d position_m =
      surface_m.head<2>() - normal.head<2>() * (surface_m.z() / normal.z());
  if (!IsInReach(position_m)) return std::nullopt;
  return position_m;
}

Eigen::Vector2d LocalFrame::TurnToPlane(const Eigen::Vector2d& along, const GeoPoint& point) const {
  // Of all turns the one that is closest to the projection of the two tangent planes on each other,
  // whose entries are products of the unit vectors East and North at either point. On the origin's
  // meridian it is exactly none.
  const double meridians_rad = DegToRad(std::remainder(point.lon_deg - origin_.lon_deg, 360));
  const double sin_lat = Sin(DegToRad(point.lat_deg));
  const double sin_origin = Sin(DegToRad(origin_.lat_deg));
  const double turn_sin = (sin_lat + sin_origin) * Sin(meridians_rad);
  const double turn_cos = (1 + sin_lat * sin_origin) * Cos(meridians_rad) +
                          Cos(DegToRad(point.lat_deg)) * Cos(DegToRad(origin_.lat_deg));
  const double length = Hypot(turn_sin, turn_cos);
  const double c = turn_cos / length;
  const double s = turn_sin / length;
  return {along.x() * c - along.y() * s, along.x() * s + along.y() * c};
}

}  // namespace shoal
