#include "lib/mission/file/load_comms.h"

#include <filesystem>
#include <sstream>
#include <variant>

#include "lib/bus/os/read_file.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/file/load.h"
#include "lib/mission/file/load_media.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/table_reader.h"
#include "lib/mission/toml/table_writer.h"

namespace shoal {

LoadedComms LoadCommsText(std::string_view text, const std::string& name) {
  LoadedComms loaded;
  Problems problems(name, {});
  if (const std::optional<Value> root = ParseToml(text, problems)) {
    const auto& table = std::get<Table>(root->data);
    for (const char* key : {"mission", "vehicle", "fleet"}) {
      if (Find(table, key) == nullptr) continue;
      LoadedMission whole = LoadMissionText(text, name);
      return {.rules = whole.mission.comms,
              .acoustics = whole.mission.acoustics,
              .mission = std::move(whole.mission),
              .errors = std::move(whole.errors),
              .warnings = std::move(whole.warnings)};
    }
    TableReader file(*root, "the file", problems);
    file.Require("comms", "[comms], followed by comms_range = 100");
    file.Below("comms", [&](Fields& fields) { Describe(fields, loaded.rules); });
    const TablePlace comms = TablePlace(*root, problems).Below("comms");
    const std::vector<std::string> media = MediaSetup().Names();
    ValidateChoice(comms, "reports_over", loaded.rules.reports_over, media);
    ValidateChoice(comms, "messages_over", loaded.rules.messages_over, media);
    if (file.Has("acoustics", true)) {
      loaded.acoustics = {.is_used = true, .crc = true, .options = {}};
      file.Below("acoustics", [&](Fields& fields) {
        Describe(fields, *loaded.acoustics, std::filesystem::path(name).parent_path().string());
      });
      const TablePlace place = TablePlace(*root, problems).Below("acoustics");
      if (place.IsSound()) ValidateNetwork(place, loaded.acoustics->options, AnyNode());
    }
  }
  loaded.errors = problems.InOrder();
  if (loaded.errors.empty()) loaded.warnings = problems.WarningsInOrder();
  return loaded;
}

LoadedComms LoadComms(const std::string& path) {
  const FileText read = ReadFile(path);
  if (read.problem.empty()) return LoadCommsText(read.text, path);
  Problems problems(path, {});
  problems.Add({}, read.problem);
  return {
      .rules = {}, .acoustics = {}, .mission = {}, .errors = problems.InOrder(), .warnings = {}};
}

std::vector<std::string> ExplainComms(const RoutingRules& rules) {
  TableWriter writer;
  RoutingRules copy = rules;
  Describe(writer, copy);
  std::istringstream text(writer.TakeText());
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

}  // namespace shoal
