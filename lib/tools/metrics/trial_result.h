// What became of a trial whose mission ran to its end.
#pragma once

#include "lib/mission/model/mission.h"
#include "lib/run/verdict/judge.h"
#include "lib/tools/metrics/trial.h"
#include "lib/tools/metrics/trial_watch.h"

namespace shoal {

/// Returns pass, or fail with each missed expectation as "text: numbers [where]" and the
/// collisions, separated by "; "; and the values of `watch`.
[[nodiscard]] TrialResult ResultOf(const Mission& mission, const Judge& judge,
                                   const TrialWatch& watch);

}  // namespace shoal
