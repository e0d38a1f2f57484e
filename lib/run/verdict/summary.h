// The last page of a mission: where each vehicle ended, which received which, what was achieved.
#pragma once

#include <string>

#include "lib/mission/model/mission.h"
#include "lib/run/verdict/judge.h"

namespace shoal {

/// Returns "a ran aground at 118.0 s at (-15.6, 0.0): 29.8 m deep, the floor at 29.8 m".
[[nodiscard]] std::string GroundingText(const Mission& mission, const GroundingFact& fact);

/// Returns the summary; its last line is "PASS", "FAIL" with how many expectations were missed and
/// how many vehicles collided or ran aground, or "INCOMPLETE" for a mission that did not run to its
/// end. Collisions and groundings are always shown; Judge::Warnings where the mission is complete.
[[nodiscard]] std::string Summarize(const Mission& mission, const Judge& judge,
                                    bool complete = true);

/// Returns "2 of 3 expectations missed, 1 collision": why a mission that ran to its end failed;
/// empty: it did not.
[[nodiscard]] std::string FailuresOf(const Mission& mission, const Judge& judge);

}  // namespace shoal
