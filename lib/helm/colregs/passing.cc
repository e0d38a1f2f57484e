#include "lib/helm/colregs/passing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

Aspect AspectOf(double alpha_deg) {
  return {.fore = alpha_deg < 90 || alpha_deg > 270, .port = alpha_deg > 180};
}

bool PassesPort(const Aspect& aspect, double bearing_rate_degps) {
  return aspect.fore ? bearing_rate_degps < -kNoDrift : bearing_rate_degps > kNoDrift;
}

bool IsBowSide(const Aspect& aspect, double bearing_rate_degps) {
  return aspect.port ? bearing_rate_degps >= -kNoDrift : bearing_rate_degps <= kNoDrift;
}

bool IsSternSide(const Aspect& aspect, double bearing_rate_degps) {
  return aspect.port ? bearing_rate_degps <= kNoDrift : bearing_rate_degps >= -kNoDrift;
}

Passing PassingOf(const VesselMotion& own, const VesselMotion& contact) {
  const RelativeGeometry geometry = GeometryOf(own, contact);
  const Aspect aspect = AspectOf(geometry.alpha_deg);
  const double own_mps = std::max(0.0, own.speed_mps);
  const double contact_mps = std::max(0.0, contact.speed_mps);
  const double across_rad = HeadingOf(contact.position_m - own.position_m) +
                            kPi / 2;  // To the right of the line of sight.
  Passing passing;
  if (geometry.range_m > 0) {
    const double drift_mps = contact_mps * Cos(DegToRad(contact.heading_deg) - across_rad) -
                             own_mps * Cos(DegToRad(own.heading_deg) - across_rad);
    passing.bearing_rate_degps = RadToDeg(drift_mps / geometry.range_m);
  }
  const double turned_rad = DegToRad(own.heading_deg - contact.heading_deg);
  const double lead_mps = contact_mps - own_mps * Cos(turned_rad);
  passing.passes = (aspect.fore ? lead_mps : -lead_mps) > kNoDrift;
  passing.passes_port = PassesPort(aspect, passing.bearing_rate_degps);
  const double to_starboard_mps = own_mps * Sin(turned_rad);
  passing.crosses = (aspect.port ? to_starboard_mps : -to_starboard_mps) > kNoDrift;
  passing.crosses_bow = passing.crosses && IsBowSide(aspect, passing.bearing_rate_degps);
  passing.crosses_stern = passing.crosses && IsSternSide(aspect, passing.bearing_rate_degps);
  return passing;
}

double CrossingDistance(const VesselMotion& own, const VesselMotion& contact) {
  const Eigen::Vector2d bow = UnitVector(DegToRad(contact.heading_deg));
  const Eigen::Vector2d starboard(bow.y(), -bow.x());
  const Eigen::Vector2d offset_m = own.position_m - contact.position_m;
  const Eigen::Vector2d velocity_mps =
      std::max(0.0, own.speed_mps) * UnitVector(DegToRad(own.heading_deg));
  const double across_m = offset_m.dot(starboard);
  const double across_mps = velocity_mps.dot(starboard);
  if (across_m * across_mps >= 0 || std::abs(across_mps) <= kNoDrift)
    return std::numeric_limits<double>::infinity();
  const double time_s = -across_m / across_mps;
  const double ahead_mps = velocity_mps.dot(bow) - std::max(0.0, contact.speed_mps);
  return offset_m.dot(bow) + ahead_mps * time_s;
}

}  // namespace shoal
