// What the expectations about encounters come to.
#pragma once

#include "lib/helm/encounters/encounter_watch.h"
#include "lib/mission/model/mission.h"
#include "lib/run/verdict/outcome.h"

namespace shoal {

/// Judges the closest of the encounters that the expectation names.
[[nodiscard]] Outcome JudgeClosestApproach(const Mission& mission,
                                           const ClosestApproachExpectation& approach,
                                           const EncounterWatch& watch);

/// Judges the lowest score of a vessel in the encounters that the expectation names; fails where
/// its role was another one.
[[nodiscard]] Outcome JudgeEncounterScore(const Mission& mission,
                                          const EncounterScoreExpectation& expected,
                                          const EncounterWatch& watch);

}  // namespace shoal
