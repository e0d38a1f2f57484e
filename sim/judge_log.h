// The same trial from its log: for missions that ran in processes of their own.
#pragma once

#include <span>
#include <string>

#include "lib/mission/model/mission.h"
#include "lib/tools/metrics/metric.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

/// Returns what RunTrial returns of the mission, from the log that `shoal run --record` or `shoal
/// sim --log` wrote of it. An error, without metrics, where the log cannot be read, is damaged, or
/// ends before the mission does. A log does not name publishers: decisions that an unregistered
/// participant published on COMMS_FATES count here, and in a live mission do not.
[[nodiscard]] TrialResult JudgeLog(const Mission& mission, std::span<const MetricSpec> metrics,
                                   const std::string& log_path);

}  // namespace shoal
