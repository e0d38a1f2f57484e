// What figures need of the mission that a log is of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/tools/plot/plot_setting.h"

namespace shoal {

struct PlotMission {
  std::optional<PlotSetting> setting = {};  ///< Absent: no mission, or one that does not load.
  std::vector<std::string> errors = {};     ///< Why it does not.
};

/// Reads the mission.toml beside `log`, with the overrides that run.txt names; nothing where there
/// is none.
[[nodiscard]] PlotMission MissionBesideLog(const std::string& log);

[[nodiscard]] PlotMission MissionFromFile(const std::string& file,
                                          const std::vector<std::string>& overrides);

}  // namespace shoal
