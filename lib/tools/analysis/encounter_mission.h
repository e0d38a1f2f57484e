// Mission files of encounters: what `shoal encounters` writes.
//
//   MissionTextOf(ImazuCase(1, options.scale), options, "imazu 1")
#pragma once

#include <cstdint>
#include <string>

#include "lib/helm/encounters/scenario.h"

namespace shoal {

struct EncounterMissionOptions {
  ScenarioScale scale = {};
  bool others_hold = false;  ///< All but the first vessel hold course, without a behavior.
  double lead_m = 0;  ///< Vessels follow their lines with this lead; 0: they aim at the goal.
  uint64_t seed = 1;  ///< Of the mission, for what is lost.

  bool operator==(const EncounterMissionOptions&) const = default;
};

/// Returns the mission file of an encounter: each vessel has a waypoint behavior through its goal
/// and a recipe of COLREGS avoidance, every report is received, and what must hold is expected.
/// `words`: the arguments of `shoal encounters` that make it.
[[nodiscard]] std::string MissionTextOf(const EncounterScenario& scenario,
                                        const EncounterMissionOptions& options,
                                        const std::string& words);

}  // namespace shoal
