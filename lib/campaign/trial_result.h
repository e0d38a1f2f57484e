// What became of a trial whose mission ran to its end.
#pragma once

#include "lib/campaign/trial.h"
#include "lib/campaign/trial_watch.h"
#include "lib/mission/mission.h"
#include "lib/verdict/judge.h"

namespace shoal {

/// Returns pass, or fail with each missed expectation as "text: numbers [where]" and the
/// collisions, separated by "; "; and the values of `watch`.
[[nodiscard]] TrialResult ResultOf(const Mission& mission, const Judge& judge,
                                   const TrialWatch& watch);

}  // namespace shoal
