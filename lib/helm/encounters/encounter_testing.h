// Vessels that keep to a plan of turns, for tests of encounters.
#pragma once

#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/helm/encounters/encounter_watch.h"
#include "lib/helm/encounters/scenario.h"

namespace shoal {

/// A change of course and speed at a time; at once.
struct PlannedTurn {
  double at_s = 0;
  double course_change_deg = 0;
  double speed_factor = 1;
};

struct PlannedVessel {
  VesselMotion motion;
  std::vector<PlannedTurn> turns = {};
};

/// Moves the vessels for `duration_s` in steps of `step_s` and returns their encounters.
inline std::vector<Encounter> EncountersOf(std::vector<PlannedVessel> vessels, double duration_s,
                                           const EncounterOptions& options = {},
                                           double step_s = 0.1) {
  EncounterWatch watch(options);
  std::vector<VesselSample> samples(vessels.size());
  const auto num_steps = static_cast<int>(duration_s / step_s + 0.5);
  for (int step = 0; step <= num_steps; ++step) {
    const double time_s = step * step_s;
    for (size_t i = 0; i < vessels.size(); ++i) {
      VesselMotion& motion = vessels[i].motion;
      samples[i] = {.is_seen = true, .motion = motion};
      for (const PlannedTurn& turn : vessels[i].turns) {
        if (static_cast<int>(turn.at_s / step_s + 0.5) != step) continue;
        motion.heading_deg = Wrap360(motion.heading_deg + turn.course_change_deg);
        motion.speed_mps *= turn.speed_factor;
      }
      motion.position_m += UnitVector(DegToRad(motion.heading_deg)) * (motion.speed_mps * step_s);
    }
    watch.Look(time_s, samples);
  }
  return watch.Encounters();
}

inline std::vector<PlannedVessel> PlanOf(const EncounterScenario& scenario) {
  std::vector<PlannedVessel> plan;
  for (const ScenarioVessel& vessel : scenario.vessels) plan.push_back({vessel.start});
  return plan;
}

}  // namespace shoal
