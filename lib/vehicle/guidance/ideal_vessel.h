// For tests of guidance: a vessel that steers ideally, turning at a limited rate, in a current.
#pragma once

#include <algorithm>
#include <functional>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/task_runner.h"

namespace shoal {

struct IdealVessel {
  Fix fix = {};
  Eigen::Vector2d current_mps = Eigen::Vector2d::Zero();
  double max_yaw_rate_radps = 0.4;

  void Step(const Guidance& guidance, double dt_s) {
    const double turn_rad = WrapPi(guidance.heading_rad - fix.heading_rad);
    const double max_turn_rad = max_yaw_rate_radps * dt_s;
    fix.heading_rad =
        WrapTwoPi(fix.heading_rad + std::clamp(turn_rad, -max_turn_rad, max_turn_rad));
    fix.position_m += (guidance.speed_mps * UnitVector(fix.heading_rad) + current_mps) * dt_s;
    fix.time_s += dt_s;
  }
};

/// Sails `vessel` under `runner` for `duration_s` or until the task is done; `watch` sees each
/// step. Returns the last guidance.
inline Guidance Sail(
    TaskRunner& runner, IdealVessel& vessel, double duration_s,
    const std::function<void(const Guidance&)>& watch = [](const Guidance&) {}) {
  constexpr double kStep_s = 0.1;
  Guidance guidance = runner.Update(vessel.fix);
  for (double time_s = 0; time_s < duration_s && !guidance.done; time_s += kStep_s) {
    vessel.Step(guidance, kStep_s);
    guidance = runner.Update(vessel.fix);
    watch(guidance);
  }
  return guidance;
}

}  // namespace shoal
