// One trial of a campaign in this process, in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "lib/mission/model/mission.h"
#include "lib/tools/metrics/metric.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

/// Runs the mission and returns its outcome with the values of TrialWatch::Names(mission,
/// metrics). An error, without metrics, where the simulation cannot go on: a log that cannot be
/// written, a participant that crashed. `progress` is called after each step with its number; may
/// be empty. `log_path` empty: no log.
/// @pre CanRunInOneProcess(mission)
[[nodiscard]] TrialResult RunTrial(const Mission& mission, std::span<const MetricSpec> metrics,
                                   const std::function<void(int64_t step)>& progress = {},
                                   const std::string& log_path = "");

}  // namespace shoal
