#include "apps/shoal/plot_recording.h"

#include <filesystem>
#include <fstream>

#include "lib/mission/load.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// What the lines of run.txt say.
struct RunText {
  std::string mission_file;
  std::vector<std::string> overrides;
};

RunText ReadRunText(const fs::path& path) {
  RunText run;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("set ")) run.overrides.push_back(line.substr(4));
    if (line.starts_with("mission_file ")) run.mission_file = line.substr(13);
  }
  return run;
}

}  // namespace

PlotMission MissionFromFile(const std::string& file, const std::vector<std::string>& overrides) {
  LoadedMission loaded = LoadMission(file, overrides);
  if (!loaded.errors.empty()) return {.errors = std::move(loaded.errors)};
  return {.setting = SettingOf(loaded.mission)};
}

PlotMission MissionBesideLog(const std::string& log) {
  const fs::path folder = fs::path(log).parent_path();
  const fs::path file = folder / "mission.toml";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  const RunText run = ReadRunText(folder / "run.txt");
  PlotMission mission = MissionFromFile(file.string(), run.overrides);
  // Without a name of its own a mission is called as its file was, before it was copied.
  if (mission.setting && mission.setting->title == "mission" && !run.mission_file.empty()) {
    mission.setting->title = fs::path(run.mission_file).stem().string();
  }
  return mission;
}

}  // namespace shoal
