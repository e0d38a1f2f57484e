#include "lib/helm/colregs/encounter_geometry.h"

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

/// Returns `bearing_deg` in [0, 360), and exactly the half degree where it is one but for rounding:
/// whether a vessel dead astern counts as on the port side must not depend on the course of both.
double RelativeBearing(double bearing_deg) {
  constexpr double kRounding_deg = 1e-9;
  const double half_deg = std::round(2 * bearing_deg) / 2;
  return Wrap360(std::abs(bearing_deg - half_deg) < kRounding_deg ? half_deg : bearing_deg);
}

}  // namespace

Eigen::Vector2d VelocityOf(const VesselMotion& vessel) {
  return std::max(0.0, vessel.speed_mps) * UnitVector(DegToRad(vessel.heading_deg));
}

double ClosestApproach(const Eigen::Vector2d& offset_m, const Eigen::Vector2d& velocity_mps,
                       double horizon_s) {
  const double speed2 = velocity_mps.squaredNorm();
  if (speed2 <= 0) return offset_m.norm();
  const double time_s = std::clamp(-offset_m.dot(velocity_mps) / speed2, 0.0, horizon_s);
  return (offset_m + velocity_mps * time_s).norm();
}

RelativeGeometry GeometryOf(const VesselMotion& own, const VesselMotion& contact) {
  RelativeGeometry geometry;
  const Eigen::Vector2d offset_m = contact.position_m - own.position_m;
  const Eigen::Vector2d velocity_mps = VelocityOf(contact) - VelocityOf(own);
  geometry.range_m = offset_m.norm();
  geometry.beta_deg = RelativeBearing(RadToDeg(HeadingOf(offset_m)) - own.heading_deg);
  geometry.alpha_deg = RelativeBearing(RadToDeg(HeadingOf(-offset_m)) - contact.heading_deg);
  if (geometry.range_m > 0) {
    geometry.range_rate_mps = offset_m.dot(velocity_mps) / geometry.range_m;
  }
  const double speed2 = velocity_mps.squaredNorm();
  if (speed2 > 0) geometry.time_to_cpa_s = std::max(0.0, -offset_m.dot(velocity_mps) / speed2);
  geometry.cpa_m = (offset_m + velocity_mps * geometry.time_to_cpa_s).norm();
  return geometry;
}

bool IsDanger(const RelativeGeometry& geometry, double min_cpa_m, double max_cpa_m) {
  constexpr double kNear_s = 10;
  const double least_m = 2 * min_cpa_m;
  const double near_m =
      std::clamp(-kNear_s * geometry.range_rate_mps, least_m, std::max(least_m, max_cpa_m));
  return geometry.range_rate_mps < 0 && geometry.cpa_m <= min_cpa_m && geometry.range_m <= near_m;
}

std::string_view Name(EncounterRole role) {
  switch (role) {
    case EncounterRole::kNone:
      return "none";
    case EncounterRole::kOvertaking:
      return "overtaking";
    case EncounterRole::kOvertaken:
      return "overtaken";
    case EncounterRole::kHeadOn:
      return "head-on";
    case EncounterRole::kGiveWay:
      return "give-way";
    case EncounterRole::kStandOn:
      return "stand-on";
  }
  return "";
}

std::string_view RuleOf(EncounterRole role) {
  switch (role) {
    case EncounterRole::kNone:
      return "";
    case EncounterRole::kOvertaking:
      return "13";
    case EncounterRole::kOvertaken:
      return "13/17";
    case EncounterRole::kHeadOn:
      return "14";
    case EncounterRole::kGiveWay:
      return "15/16";
    case EncounterRole::kStandOn:
      return "15/17";
  }
  return "";
}

EncounterRole Classify(const RelativeGeometry& geometry, double own_speed_mps,
                       double contact_speed_mps, double risk_m, const ClassifyOptions& options) {
  if (geometry.range_rate_mps >= 0 || geometry.cpa_m > risk_m) return EncounterRole::kNone;
  const double beta_deg = Wrap180(geometry.beta_deg);
  const double alpha_deg = Wrap180(geometry.alpha_deg);
  if (std::abs(alpha_deg) >= options.sidelight_deg && own_speed_mps > contact_speed_mps) {
    return EncounterRole::kOvertaking;
  }
  if (std::abs(beta_deg) >= options.sidelight_deg && contact_speed_mps > own_speed_mps) {
    return EncounterRole::kOvertaken;
  }
  if (std::abs(beta_deg) <= options.head_on_deg && std::abs(alpha_deg) <= options.head_on_deg) {
    return EncounterRole::kHeadOn;
  }
  return beta_deg >= 0 ? EncounterRole::kGiveWay : EncounterRole::kStandOn;
}

}  // namespace shoal
