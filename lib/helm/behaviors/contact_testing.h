// For tests of contact behaviors: own ship, one contact, and what a behavior is given.
#pragma once

#include <string>
#include <vector>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal {

/// Own ship and the contact "bravo".
class TestMeeting {
 public:
  TestVessel vessel;
  Contacts contacts;
  std::vector<Obstacle> obstacles;

  TestMeeting(const VesselMotion& own, const VesselMotion& contact) {
    vessel.own.motion = own;
    contacts["bravo"] = {.name = "bravo", .reported = contact, .now = contact};
  }

  ContactView& contact() { return contacts.at("bravo"); }

  BehaviorInputs Inputs() const {
    BehaviorInputs inputs = vessel.Inputs();
    inputs.contacts = &contacts;
    inputs.obstacles = &obstacles;
    return inputs;
  }
  BehaviorAnswer Run(Behavior& behavior) const { return behavior.Run(Inputs()); }
  BestPoint Best(Behavior& behavior) const { return vessel.Best(Run(behavior)); }

  /// Own ship follows what the behavior likes most, at once; all move on for `dt_s`.
  BehaviorAnswer Step(Behavior& behavior, double dt_s);
};

inline BehaviorAnswer TestMeeting::Step(Behavior& behavior, double dt_s) {
  BehaviorAnswer answer = Run(behavior);
  VesselMotion& own = vessel.own.motion;
  if (answer.objective) {
    const BestPoint best = vessel.Best(answer);
    own.heading_deg = best.course_deg;
    own.speed_mps = best.speed_mps;
  }
  own.position_m += VelocityOf(own) * dt_s;
  for (auto& [name, each] : contacts) {
    each.now.position_m += VelocityOf(each.now) * dt_s;
    each.reported = each.now;
  }
  vessel.time_s += dt_s;
  return answer;
}

}  // namespace shoal
