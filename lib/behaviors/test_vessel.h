// For tests of behaviors: a vessel, what a behavior is given, and what it prefers.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <vector>

#include "lib/behaviors/behavior.h"
#include "lib/check/bounds.h"
#include "lib/decision/domain.h"

namespace shoal {

/// Returns the value of an objective at grid indices.
inline double ValueAt(const Objective& objective, int course, int speed, int depth = 0) {
  const auto part = [](const std::vector<double>& values, int index) {
    return values.empty() ? 0 : values.at(static_cast<size_t>(index));
  };
  const double coupled = objective.coupled ? objective.coupled->At(course, speed) : 0;
  return objective.offset +
         objective.scale * (part(objective.course, course) + part(objective.speed, speed) +
                            part(objective.depth, depth) + coupled);
}

/// The best point of an objective; the lowest course, speed and depth of several.
struct BestPoint {
  double course_deg = 0;
  double speed_mps = 0;
  double depth_m = 0;
};

inline BestPoint BestOf(const Objective& objective, const Domain& domain) {
  BestPoint best;
  double greatest = -kInfinity;
  for (int depth = 0; depth < std::max(1, domain.depth_m.count); ++depth) {
    for (int course = 0; course < Domain::kNumCourses; ++course) {
      for (int speed = 0; speed < domain.speed_mps.count; ++speed) {
        const double value = ValueAt(objective, course, speed, depth);
        if (value <= greatest + 1e-9) continue;
        greatest = value;
        best = {.course_deg = static_cast<double>(course),
                .speed_mps = domain.speed_mps.At(speed),
                .depth_m = domain.depth_m.count > 0 ? domain.depth_m.At(depth) : 0};
      }
    }
    if (objective.depth.empty()) break;
  }
  return best;
}

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
    return BestOf(answer.objective.value_or(Objective()), domain);
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
