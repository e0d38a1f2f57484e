#include "lib/tools/moos/import_scripts.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/mission/toml/table_writer.h"
#include "lib/tools/moos/import_settings.h"
#include "lib/tools/moos/script_timers.h"

namespace shoal {

void ScriptImport::Read(const std::vector<MoosFile>& files, FleetImport* fleet) {
  const std::vector<std::string> names = fleet->Names();
  for (const MoosFile& file : files) {
    for (const MoosBlock& block : file.blocks) {
      if (AppClass(block.app) != "ufldshorebroker") continue;
      for (const MoosLine& line : block.lines) {
        if (bridges_.Add(line)) bridge_lines_.insert(line.origin);
      }
    }
  }
  for (size_t i = 0; i < files.size(); ++i) {
    VehicleImport* vehicle = fleet->OfFile(i);
    for (const MoosBlock& block : files[i].blocks) {
      if (AppClass(block.app) != "utimerscript") continue;
      TimerScript& script = scripts_[&block];
      script = ReadTimerScript(
          block, vehicle == nullptr ? "" : vehicle->name(), names,
          [&](std::string_view name, std::string_view variable) {
            return fleet->HasVariable(name, variable);
          },
          [&](std::string_view posted) { return bridges_.Find(posted, names); });
      if (vehicle != nullptr) MakeScriptTimers(&script, vehicle);
    }
  }
}

double ScriptImport::AddEvents(const std::vector<MoosFile>& files, MissionDraft* draft) {
  double last_s = 0;
  for (const MoosFile& file : files) {
    for (const MoosBlock& block : file.blocks) {
      const auto script = scripts_.find(&block);
      if (script == scripts_.end()) continue;
      for (const TimerEvent& event : script->second.events) {
        if (event.keys.empty()) continue;
        AddEvent(event, draft);
        last_s = std::max(last_s, event.at_s);
      }
    }
  }
  return last_s;
}

void ScriptImport::AddEvent(const TimerEvent& event, MissionDraft* draft) {
  const std::string& origin = event.origin;
  const std::string table = fmt::format("event {}", num_events_++);
  draft->AddTable(table, "[[event]]");
  draft->Set(table, {.key = "at_s",
                     .value = TomlNumber(event.at_s),
                     .origin = origin,
                     .text = "event at " + TomlNumber(event.at_s) + " s",
                     .reason = event.assumed.empty() ? "" : "Assumed: " + event.assumed + "."});
  for (const auto& [key, value] : event.keys) {
    draft->Set(table, {.key = key, .value = value, .origin = "", .text = "", .reason = ""});
  }
}

void ScriptImport::Remark(const MoosBlock& block, const MoosLine& line, std::string_view table,
                          MissionDraft* draft, ImportLosses* losses) const {
  const TimerScript& script = scripts_.at(&block);
  const std::string& origin = line.origin;
  std::string reason = std::string(KeyCounterpart(line.key));
  const bool is_taken =
      std::find(script.taken.begin(), script.taken.end(), line.number) != script.taken.end();
  if (is_taken) reason = "counts in the events of the script";
  bool is_warning = false;
  for (const auto& [number, loss] : script.losses) {
    if (number != line.number) continue;
    reason = loss;
    is_warning = true;
  }
  for (const TimerEvent& event : script.events) {
    if (event.line != line.number) continue;
    if (!event.keys.empty()) return;  // One of its rounds at least.
    reason = event.reason;
    is_warning = !event.is_needless;
  }
  draft->Remark(table, origin, line.text, reason);
  if (is_warning) losses->Warn(origin + ": " + line.text + ": " + reason);
}

}  // namespace shoal
