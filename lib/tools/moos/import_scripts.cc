#include "lib/tools/moos/import_scripts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/helm/modes/condition.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/tools/moos/bhv_text.h"
#include "lib/tools/moos/import_names.h"
#include "lib/tools/moos/import_settings.h"
#include "lib/tools/moos/moos_readers.h"
#include "lib/tools/moos/script_timers.h"
#include "lib/tools/moos/sim_drift.h"

namespace shoal {

namespace {

/// Returns true where the line of ANTLER that runs timer scripts is switched off by a comment.
bool IsSwitchedOff(const MoosFile& file) {
  const auto is_script = [](const std::string& app) { return AppClass(app) == "utimerscript"; };
  if (std::none_of(file.stopped_apps.begin(), file.stopped_apps.end(), is_script)) return false;
  for (const MoosBlock& block : file.blocks) {
    if (AppClass(block.app) != "antler") continue;
    for (const MoosLine& line : block.lines) {
      if (LowerCase(line.key) == "run" && is_script(AppNameOfRun(line.value))) return false;
    }
  }
  return true;
}

/// Returns the variables that pObstacleMgr takes points from.
std::set<std::string, std::less<>> PointVariables(const std::vector<MoosFile>& files) {
  std::set<std::string, std::less<>> variables;
  for (const MoosFile& file : files) {
    for (const MoosBlock& block : file.blocks) {
      if (AppClass(block.app) != "pobstaclemgr") continue;
      std::string variable = "TRACKED_FEATURE";
      for (const MoosLine& line : block.lines) {
        if (LowerCase(line.key) == "point_var") variable = line.value;
      }
      variables.insert(std::move(variable));
    }
  }
  return variables;
}

/// Returns the drift that uSimMarine begins with.
Eigen::Vector2d FirstDrift_mps(const MoosFile& file) {
  Eigen::Vector2d drift_mps(0, 0);
  for (const MoosBlock& block : file.blocks) {
    if (AppClass(block.app) != "usimmarine") continue;
    for (const MoosLine& line : block.lines) {
      TakeDriftLine(LowerCase(line.key), line.value, &drift_mps);
    }
  }
  return drift_mps;
}

/// Returns the condition for which the script waits until a user presses a button; nullptr: none.
const MoosLine* WaitsForButton(const MoosBlock& block, const std::vector<MoosFile>& files,
                               const PostImport& posts, const std::vector<MoosButton>& pokes,
                               const FleetImport& fleet) {
  const auto is_set_otherwise = [&](std::string_view variable) {
    for (const MoosButton& poke : pokes) {
      for (const auto& [posted, value] : poke.posts) {
        if (posted == variable) return true;
      }
    }
    for (const VehicleImport& vehicle : fleet.vehicles()) {
      if (vehicle.behaviors().words.contains(variable)) return true;
    }
    for (const MoosFile& file : files) {
      for (const MoosBlock& each : file.blocks) {
        for (const MoosLine& line : each.lines) {
          std::set<std::string, std::less<>> words;
          CollectVariables(line.value, &words);
          const std::string app_class = AppClass(each.app);
          const bool is_condition = LowerCase(line.key) == "condition";
          if (app_class != "pmarineviewer" && !is_condition && words.contains(variable))
            return true;
        }
      }
    }
    return false;
  };
  for (const MoosLine& line : block.lines) {
    if (LowerCase(line.key) != "condition") continue;
    const auto condition = Condition::Parse(ConditionText(line.value));
    if (!condition.ok()) continue;
    for (const std::string& variable : condition->VariablesUsed()) {
      if (posts.SetsAlone(variable) && !is_set_otherwise(variable)) return &line;
    }
  }
  return nullptr;
}

}  // namespace

void ScriptImport::ReadBridges(const std::vector<MoosFile>& files) {
  for (const MoosFile& file : files) {
    for (const MoosBlock& block : file.blocks) {
      if (AppClass(block.app) != "ufldshorebroker") continue;
      for (const MoosLine& line : block.lines) {
        if (bridges_.Add(line)) bridge_lines_.insert(line.origin);
      }
    }
  }
}

void ScriptImport::Read(const std::vector<MoosFile>& files, const PostImport& posts,
                        const std::vector<MoosButton>& pokes, FleetImport* fleet,
                        ImportLosses* losses) {
  ReadBridges(files);
  const std::vector<std::string> names = fleet->Names();
  const MoosReaders readers(files, fleet);
  TimerContext context{.vehicles = names};
  context.has_variable = [&](std::string_view name, std::string_view variable) {
    return fleet->HasVariable(name, variable);
  };
  context.find_bridge = [&](std::string_view posted) { return bridges_.Find(posted, names); };
  context.point_variables = PointVariables(files);
  context.first_drift_mps = [&](std::string_view name) {
    for (size_t i = 0; i < fleet->num_described(); ++i) {
      if (fleet->vehicles()[i].name() == name) return FirstDrift_mps(files[fleet->FileOf(i)]);
    }
    return Eigen::Vector2d(0, 0);
  };
  for (size_t i = 0; i < files.size(); ++i) {
    VehicleImport* vehicle = fleet->OfFile(i);
    context.vehicle = vehicle == nullptr ? std::string_view() : vehicle->name();
    context.may_be_read = [&](std::string_view posted) {
      return readers.MayRead(context.vehicle, posted,
                             vehicle == nullptr ? bridges_.Find(posted, names) : std::string());
    };
    context.may_be_set = [&](std::string_view variable) {
      return vehicle != nullptr && vehicle->behaviors().words.contains(variable);
    };
    for (const MoosBlock& block : files[i].blocks) {
      if (AppClass(block.app) != "utimerscript") continue;
      const MoosLine* button = WaitsForButton(block, files, posts, pokes, *fleet);
      context.idle = IsSwitchedOff(files[i]) ? "a comment switches the script off"
                     : button != nullptr     ? "the script waits for a button"
                                             : "";
      if (button != nullptr) {
        losses->Lose(fmt::format("{}: {}: only a button sets it: the script's events are left out",
                                 button->origin, button->text));
      }
      TimerScript& script = scripts_[&block];
      script = ReadTimerScript(block, context);
      if (vehicle != nullptr) MakeScriptTimers(&script, vehicle);
    }
  }
}

std::vector<TimerEvent> ScriptImport::Points(const std::vector<MoosFile>& files) const {
  std::vector<TimerEvent> points;
  int num_scripts = 0;
  for (const MoosFile& file : files) {
    for (const MoosBlock& block : file.blocks) {
      const auto script = scripts_.find(&block);
      if (script == scripts_.end()) continue;
      ++num_scripts;
      for (const TimerEvent& event : script->second.events) {
        if (!event.point) continue;
        points.push_back(event);
        points.back().point->script = num_scripts;
      }
    }
  }
  return points;
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
