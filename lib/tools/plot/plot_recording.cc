#include "lib/tools/plot/plot_recording.h"

#include "lib/mission/file/load.h"
#include "lib/mission/file/recorded_mission.h"

namespace shoal {

PlotMission MissionFromFile(const std::string& file, const std::vector<std::string>& overrides) {
  LoadedMission loaded = LoadMission(file, overrides);
  if (!loaded.errors.empty()) return {.errors = std::move(loaded.errors)};
  return {.setting = SettingOf(loaded.mission)};
}

PlotMission MissionBesideLog(const std::string& log) {
  RecordedMission recorded = FindMissionBeside(log);
  if (!recorded.mission) return {.errors = std::move(recorded.errors)};
  return {.setting = SettingOf(*recorded.mission)};
}

}  // namespace shoal
