#include "lib/helm/behaviors/trail.h"

#include <memory>
#include <string>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/approach_function.h"
#include "lib/helm/behaviors/contact_aim.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

namespace {

constexpr double kHorizon_s = 60;
constexpr double kPeak_deg = 30;
constexpr double kBase_deg = 150;
constexpr double kPeak_mps = 0.1;
constexpr double kBase_mps = 2;
constexpr double kDelta = 50;
constexpr double kSlowDown = 0.5;  // At nm_radius ahead of the point.

BehaviorAnswer Steer(const BehaviorInputs& inputs, double course_deg, double speed_mps) {
  return PreferBoth(inputs, PeakOverCourse(course_deg, kPeak_deg, kBase_deg, kDelta),
                    PeakOverAxis(inputs.domain->speed_mps, speed_mps, kPeak_mps, kBase_mps, kDelta),
                    50);
}

}  // namespace

BehaviorAnswer TrailBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  const ContactView* contact = KnownContact(options_.contact, inputs, answer);
  if (contact == nullptr) return answer;
  const VesselMotion& own = inputs.own.motion;
  const VesselMotion& theirs = contact->now;
  const RelativeGeometry geometry = GeometryOf(own, theirs);
  if (options_.pwt_outer_dist > 0 && geometry.range_m >= options_.pwt_outer_dist) {
    Post(answer, "PURSUIT", 0);
    DescribeContact(options_.contact, *contact, geometry, "trail", "", answer);
    return answer;
  }
  const double angle_deg = options_.trail_angle_type == "absolute"
                               ? options_.trail_angle
                               : theirs.heading_deg + options_.trail_angle;
  const Eigen::Vector2d bow = UnitVector(DegToRad(theirs.heading_deg));
  const Eigen::Vector2d point_m =
      theirs.position_m + options_.trail_range * UnitVector(DegToRad(angle_deg));
  const Eigen::Vector2d offset_m = point_m - own.position_m;
  const double distance_m = offset_m.norm();
  std::string region;
  if (distance_m > options_.nm_radius) {
    region = "outside nm_radius";
    answer = Prefer(inputs, {.coupled = std::make_shared<ApproachFunction>(
                                 ApproachFunction::Target{.offset_m = offset_m,
                                                          .velocity_mps = VelocityOf(theirs),
                                                          .horizon_s = kHorizon_s},
                                 ApproachFunction::Shares{}, *inputs.domain)});
  } else if (distance_m > options_.radius) {
    region = "inside nm_radius";
    const double ahead_m = -offset_m.dot(bow);
    answer = Steer(inputs, BearingDeg(own.position_m, point_m + options_.nm_radius * bow),
                   theirs.speed_mps * (1 - kSlowDown * ahead_m / options_.nm_radius));
  } else {
    region = "inside radius";
    answer = Steer(inputs, theirs.heading_deg, theirs.speed_mps);
  }
  Post(answer, "PURSUIT", 1);
  Post(answer, "REGION", region);
  Post(answer, "TRAIL_DISTANCE", distance_m);
  DescribeContact(options_.contact, *contact, geometry, "trail", "", answer);
  answer.state += ", " + region;
  answer.view.points_m = {point_m};
  answer.view.steers_for_m = point_m;
  return answer;
}

BehaviorAnswer TrailBehavior::Idle(const BehaviorInputs&) {
  BehaviorAnswer answer;
  Post(answer, "PURSUIT", 0);
  return answer;
}

}  // namespace shoal
