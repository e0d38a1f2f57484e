// Finds the mission that a log is of: `shoal run --record` puts it beside the log.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/mission/model/mission.h"

namespace shoal {

struct RecordedMission {
  std::optional<Mission> mission = {};   ///< Absent: there is none, or it does not load.
  std::vector<std::string> errors = {};  ///< Why it does not.
};

/// Reads the mission.toml beside `log`, with the overrides that run.txt names. Without a name of
/// its own the mission is called as its file was, before it was copied.
[[nodiscard]] RecordedMission FindMissionBeside(const std::string& log);

}  // namespace shoal
