#include "lib/mission/file/load.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "lib/bus/os/read_file.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/file/expand.h"
#include "lib/mission/file/key_homes.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/toml/override.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/table_reader.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/mission/toml/value.h"

namespace shoal {
namespace {

/// Templates are checked as vehicles without a name, whether one uses them or not.
void CheckTemplates(const Table& root, Problems& problems) {
  const Value* templates = Find(root, "template");
  if (templates == nullptr) return;
  const auto* table = std::get_if<Table>(&templates->data);
  if (table == nullptr) {
    problems.Add(templates->place, "templates have names: write [template.NAME]");
    return;
  }
  for (const Entry& entry : *table) {
    TableReader reader(entry.value, "template", problems);
    Vehicle vehicle;
    Describe(reader, vehicle);
    if (reader.Has("name", false)) {
      reader.Refuse("name", "a template must not have a name; its vehicles have");
    }
    if (reader.Has("acoustic_address", false)) {
      reader.Refuse("acoustic_address",
                    "a template must not have an acoustic_address; each vehicle has its own");
    }
  }
}

/// Overrides of vehicles go to the finished vehicles, so that those of fleets can be named; but
/// which template a vehicle has must be known before.
bool IsForFinishedVehicles(const Override& override_) {
  const auto& path = override_.path;
  return path.front() == "vehicle" && !(path.size() == 3 && path.back() == "template");
}

Mission Read(Value& root, const std::vector<Override>& overrides, const std::string& name,
             Problems& problems) {
  for (const Override& override_ : overrides) {
    if (!IsForFinishedVehicles(override_)) Apply(override_, root, problems);
  }
  ExpandTemplates(root, problems);
  CheckTemplates(std::get<Table>(root.data), problems);
  ExpandVehicles(root, problems);
  for (const Override& override_ : overrides) {
    if (IsForFinishedVehicles(override_)) Apply(override_, root, problems);
  }
  Mission mission;
  mission.file = name;
  mission.name = std::filesystem::path(name).stem().string();
  {
    TableReader reader(root, "the file", problems);
    Describe(reader, mission);
  }
  Validate(mission, TablePlace(root, problems));
  return mission;
}

/// Returns " (did you mean missions/alpha.toml?)" where `path` lacks its folder or its ending.
std::string MissionMeant(const std::string& path) {
  std::error_code error;
  if (path.empty() || std::filesystem::exists(path, error)) return {};
  for (const char* folder : {"", "missions/", "/usr/share/shoal/missions/"}) {
    for (const char* ending : {"", ".toml"}) {
      const std::string meant = folder + path + ending;
      if (std::filesystem::is_regular_file(meant, error)) {
        return fmt::format(" (did you mean {}?)", meant);
      }
    }
  }
  return {};
}

}  // namespace

LoadedMission LoadMissionText(std::string_view text, const std::string& name,
                              const std::vector<std::string>& overrides) {
  Problems problems(name, overrides);
  problems.SetHomes(HomeOfKey);
  std::vector<Override> parsed;
  for (size_t i = 0; i < overrides.size(); ++i) {
    auto override_ = ParseOverride(overrides[i], static_cast<int64_t>(i) + 1, problems);
    if (override_) parsed.push_back(std::move(*override_));
  }
  LoadedMission loaded;
  std::optional<Value> root = ParseToml(text, problems);
  if (root) loaded.mission = Read(*root, parsed, name, problems);
  loaded.errors = problems.InOrder();
  if (!loaded.errors.empty()) return loaded;
  loaded.warnings = problems.WarningsInOrder();
  loaded.num_sure_failures = problems.num_failures();
  return loaded;
}

LoadedMission LoadMission(const std::string& path, const std::vector<std::string>& overrides) {
  FileText read = ReadFile(path);
  if (!read.problem.empty()) {
    Problems problems(path, overrides);
    problems.Add({}, read.problem + MissionMeant(path));
    return {.mission = {}, .errors = problems.InOrder(), .warnings = {}};
  }
  return LoadMissionText(read.text, path, overrides);
}

std::string Explain(const Mission& mission) {
  TableWriter writer;
  Mission copy = mission;
  Describe(writer, copy);
  std::string text = writer.TakeText();
  text.erase(0, text.find_first_not_of('\n'));
  return text;
}

}  // namespace shoal
