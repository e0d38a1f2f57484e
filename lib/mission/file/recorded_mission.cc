#include "lib/mission/file/recorded_mission.h"

#include <filesystem>
#include <sstream>
#include <system_error>

#include "lib/bus/os/read_file.h"
#include "lib/bus/record/log_reader.h"
#include "lib/mission/file/load.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// The contents of run.txt.
struct RunText {
  std::string mission_file;
  std::vector<std::string> overrides;
  std::string problem;  ///< Why it cannot be used.
};

/// Without the file, everything is empty.
RunText ReadRunText(const fs::path& path) {
  RunText run;
  if (std::error_code ignored; !fs::exists(fs::symlink_status(path, ignored))) return run;
  const FileText file = ReadRegularFile(path.string(), kLargestRunFile_bytes);
  if (!file.problem.empty()) run.problem = path.string() + ": " + file.problem;
  std::istringstream in(file.text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("set ")) run.overrides.push_back(line.substr(4));
    if (line.starts_with("mission_file ")) run.mission_file = line.substr(13);
  }
  return run;
}

}  // namespace

RecordedMission FindMissionBeside(const std::string& log) {
  const fs::path folder = fs::path(LogFileOf(log)).parent_path();
  const fs::path file = folder / "mission.toml";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  const RunText run = ReadRunText(folder / "run.txt");
  if (!run.problem.empty()) return {.errors = {run.problem}};
  LoadedMission loaded = LoadMission(file.string(), run.overrides);
  if (!loaded.errors.empty()) return {.errors = std::move(loaded.errors)};
  if (loaded.mission.name == "mission" && !run.mission_file.empty()) {
    loaded.mission.name = fs::path(run.mission_file).stem().string();
  }
  return {.mission = std::move(loaded.mission)};
}

}  // namespace shoal
