// The folder of a recorded run: mission.lcm, and beside it what is needed to run it again.
#pragma once

#include <string>

#include "lib/base/check/result.h"
#include "lib/run/launch/launch_plan.h"

namespace shoal {

/// Makes the folder and writes mission.toml (the file as it was), run.txt (version,
/// arithmetic, seed, options, overrides). Refuses a folder that is not empty.
[[nodiscard]] Result<bool> PrepareRecording(const RunOptions& options, const Mission& mission);

/// Writes summary.txt: what the terminal showed at the end.
[[nodiscard]] Result<bool> WriteSummary(const std::string& dir, const std::string& summary);

/// Writes verdict.txt (lib/run/verdict/mission_verdict.h).
[[nodiscard]] Result<bool> WriteVerdict(const std::string& dir, const std::string& verdict);

}  // namespace shoal
