// For tests of behaviors: a vessel, what a behavior is given, and what it prefers.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/decision/decide.h"

namespace shoal {

/// Returns the value of an objective at grid indices.
inline double ValueAt(const Objective& objective, int course, int speed, int depth = 0) {
  return ValueOf(objective, course, speed, depth);
}

/// The best point of an answer; the lowest course, speed and depth of several. -1: not mentioned.
struct BestPoint {
  double course_deg = -1;
  double speed_mps = -1;
  double depth_m = -1;
};

/// A vessel that the test moves, with a helm that decides about course, speed and depth.
class TestVessel {
 public:
  double time_s = 0;
  OwnMotion own = {};
  Domain domain = {.depth_m = {.first = 0, .step = 1, .count = 101}};
  Variables variables = {};

  BehaviorInputs Inputs() const {
    return {.time_s = time_s, .own = own, .domain = &domain, .variables = &variables};
  }
  BehaviorAnswer Run(Behavior& behavior) const { return behavior.Run(Inputs()); }
  /// Runs it at another place.
  BehaviorAnswer RunAt(Behavior& behavior, const Eigen::Vector2d& position_m) {
    own.motion.position_m = position_m;
    return Run(behavior);
  }
  /// Runs it at another time.
  BehaviorAnswer RunAt(Behavior& behavior, double new_time_s) {
    time_s = new_time_s;
    return Run(behavior);
  }
  /// What an answer likes most. A failure where it has no preference.
  BestPoint Best(const BehaviorAnswer& answer) const {
    EXPECT_TRUE(answer.objective.has_value());
    if (!answer.objective) return {};
    const std::vector<WeightedObjective> alone = {{.weight = 1, .objective = *answer.objective}};
    const DomainPoint point = Decide(domain, alone).point;
    BestPoint best;
    if (point.course) best.course_deg = *point.course;
    if (point.speed) best.speed_mps = domain.speed_mps.At(*point.speed);
    if (point.depth) best.depth_m = domain.depth_m.At(*point.depth);
    return best;
  }
};

/// Returns the last value that the answer posts for a variable; empty text where it posts none.
inline VariableValue PostOf(const BehaviorAnswer& answer, const std::string& variable) {
  VariableValue value;
  for (const VariablePost& post : answer.posts) {
    if (post.variable == variable) value = post.value;
  }
  return value;
}

}  // namespace shoal
