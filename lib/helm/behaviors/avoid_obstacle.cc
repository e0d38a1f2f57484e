#include "lib/helm/behaviors/avoid_obstacle.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/contact_aim.h"
#include "lib/helm/behaviors/contact_recipe.h"
#include "lib/helm/behaviors/obstacle_path.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

namespace {

constexpr double kAbaft_deg = 110;  // 20 degrees abaft the beam.
constexpr double kLeastRelevance = 0.01;
constexpr double kLockRelevance = 0.6;
constexpr double kUnlockRelevance = 0.1;

/// By how much own heading misses the obstacle, degrees; 0: points at it.
double OffBow(const VesselMotion& own, const std::vector<Eigen::Vector2d>& polygon_m) {
  double to_port_deg = 0;
  double to_starboard_deg = 0;
  double nearest_deg = 180;
  for (const Eigen::Vector2d& corner_m : polygon_m) {
    const double off_deg = Wrap180(BearingDeg(own.position_m, corner_m) - own.heading_deg);
    to_port_deg = std::min(to_port_deg, off_deg);
    to_starboard_deg = std::max(to_starboard_deg, off_deg);
    nearest_deg = std::min(nearest_deg, std::abs(off_deg));
  }
  // Corners on both sides of the bow, and not around the stern.
  const bool points_at_it =
      to_port_deg < 0 && to_starboard_deg > 0 && to_starboard_deg - to_port_deg < 180;
  return points_at_it ? 0 : nearest_deg;
}

Eigen::Vector2d CentreOf(const std::vector<Eigen::Vector2d>& polygon_m) {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner_m : polygon_m) sum_m += corner_m;
  return sum_m / static_cast<double>(polygon_m.size());
}

}  // namespace

const std::vector<Eigen::Vector2d>* AvoidObstacleBehavior::Polygon(
    const BehaviorInputs& inputs) const {
  if (!options_.polygon.empty()) return &options_.polygon;
  if (inputs.obstacles == nullptr) return nullptr;
  const auto found = std::find_if(inputs.obstacles->begin(), inputs.obstacles->end(),
                                  [&](const Obstacle& each) { return each.id == options_.id; });
  return found == inputs.obstacles->end() ? nullptr : &found->polygon_m;
}

void AvoidObstacleBehavior::LockSide(const Eigen::Vector2d& centre_m, const VesselMotion& own,
                                     double relevance) {
  if (relevance < kUnlockRelevance) {
    side_ = Side::kFree;
  } else if (relevance > kLockRelevance && side_ == Side::kFree) {
    const double off_deg = Wrap180(BearingDeg(own.position_m, centre_m) - own.heading_deg);
    side_ = off_deg < 0 ? Side::kObstacleToPort : Side::kObstacleToStarboard;
  }
}

bool AvoidObstacleBehavior::LeadsAcross(double bearing_deg, double heading_deg,
                                        double course_deg) const {
  if (side_ == Side::kFree) return false;
  const double to_starboard = side_ == Side::kObstacleToStarboard ? 1 : -1;
  const double beyond_deg = to_starboard * Wrap180(course_deg - bearing_deg);
  if (beyond_deg > 0 && beyond_deg < 90) return true;
  const double off_bow_deg = to_starboard * Wrap180(bearing_deg - heading_deg);
  const double turn_deg = to_starboard * Wrap180(course_deg - heading_deg);
  return off_bow_deg > 0 && turn_deg > off_bow_deg && turn_deg < 180;
}

void AvoidObstacleBehavior::FireFlags(double distance_m, BehaviorAnswer& answer) {
  if (distance_m >= options_.pwt_outer_dist) {
    came_near_ = false;
    passed_ = false;
  } else {
    if (distance_m <= options_.pwt_inner_dist && !came_near_) {
      answer.flags.push_back("rng_flag");
      came_near_ = true;
    }
    if (last_distance_m_ >= 0 && distance_m > last_distance_m_ && !passed_) {
      answer.flags.push_back("cpa_flag");
      passed_ = true;
    }
  }
  last_distance_m_ = distance_m;
}

BehaviorAnswer AvoidObstacleBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  const std::vector<Eigen::Vector2d>* polygon_m = Polygon(inputs);
  if (polygon_m == nullptr || polygon_m->size() < 3) {
    answer.warning = "the obstacle '" + options_.id + "' is not known";
    return answer;
  }
  const VesselMotion& own = inputs.own.motion;
  const double distance_m = DistanceTo(*polygon_m, own.position_m);
  answer.state = options_.id + ", " + Whole(distance_m) + " m";
  answer.view = {.points_m = *polygon_m, .closed = true};
  FireFlags(distance_m, answer);
  if (distance_m <= 0) {
    (options_.allstop_on_breach ? answer.error : answer.warning) =
        "own ship is inside the obstacle '" + options_.id + "'";
    return answer;
  }
  const double off_bow_deg = OffBow(own, *polygon_m);
  const double near =
      RelevanceAt(distance_m, options_.pwt_inner_dist, options_.pwt_outer_dist, "linear");
  if (near <= 0 || off_bow_deg > kAbaft_deg) {
    side_ = Side::kFree;
    return answer;
  }
  const double relevance =
      std::max(kLeastRelevance, near * std::max(0.0, Cos(DegToRad(off_bow_deg))));
  const Eigen::Vector2d centre_m = CentreOf(*polygon_m);
  LockSide(centre_m, own, relevance);

  const double lo_m =
      distance_m <= options_.min_util_cpa_dist ? distance_m / 2 : options_.min_util_cpa_dist;
  const double span_m = std::max(options_.max_util_cpa_dist - lo_m, 1e-6);
  const TurnThenStraight path = {
      .turn_radius_m = options_.holonomic_ok ? 0 : options_.turn_radius,
      .reach_m = options_.allowable_ttc * inputs.domain->speed_mps.Last()};
  std::vector<double> values = ClearanceOfCourses(own, path, *polygon_m);
  const double bearing_deg = BearingDeg(own.position_m, centre_m);
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    double& value = values[static_cast<size_t>(course)];
    value = 100 * std::clamp((value - lo_m) / span_m, 0.0, 1.0);
    if (LeadsAcross(bearing_deg, own.heading_deg, course)) value = 0;
  }
  if (*std::max_element(values.begin(), values.end()) <= 0) {
    answer.error = "no course keeps clear of the obstacle '" + options_.id + "'";
    return answer;
  }
  BehaviorAnswer preferred = Prefer(inputs, {.course = std::move(values)});
  answer.objective = std::move(preferred.objective);
  answer.relevance = relevance;
  return answer;
}

}  // namespace shoal
