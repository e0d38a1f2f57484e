#include "lib/tools/moos/script_timers.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/reported_variables.h"
#include "lib/helm/modes/condition.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/tools/moos/bhv_text.h"

namespace shoal {
namespace {

bool IsOrder(std::string_view name) {
  return name == "DEPLOY" || name == "RETURN" || name == "STATION_KEEP";
}

/// Returns the argument of `command = "set"` as it is in TOML; empty: another event.
std::string_view SettingOfEvent(const TimerEvent& event) {
  std::string_view argument;
  bool sets = false;
  for (const auto& [key, value] : event.keys) {
    sets = sets || (key == "command" && value == TomlString("set"));
    if (key == "argument") argument = value;
  }
  return sets ? argument : std::string_view();
}

/// Returns the conditions as behaviors have them; nothing where one is of no use here.
std::vector<std::string> UsableConditions(const TimerScript& script, const VehicleImport& vehicle) {
  std::vector<std::string> texts;
  bool waits_for_orders_only = true;
  for (const std::string& condition : script.conditions) {
    texts.push_back(ConditionText(condition));
    const auto parsed = Condition::Parse(texts.back());
    if (!parsed.ok()) return {};
    for (const std::string& name : parsed->VariablesUsed()) {
      if (!vehicle.behaviors().words.contains(name) && !IsReportedVariable(name)) return {};
      waits_for_orders_only = waits_for_orders_only && IsOrder(name);
    }
  }
  if (script.num_resets > 0 && waits_for_orders_only) return {};
  return texts;
}

/// Returns true where timers do what the script's events do: these only set variables, there are
/// not too many, and a script that is repeated gives each variable one value.
bool AreTimers(const TimerScript& script) {
  constexpr int kMostTimers = 100;
  int num_timers = 0;
  std::map<std::string_view, std::string_view> values;
  for (const TimerEvent& event : script.events) {
    if (event.keys.empty()) continue;
    const std::string_view setting = SettingOfEvent(event);
    if (setting.empty()) return false;
    if (event.round == 0 && ++num_timers > kMostTimers) return false;
    const std::string_view variable = setting.substr(0, setting.find('='));
    const auto [place, is_new] = values.emplace(variable, setting);
    if (!is_new && script.num_resets > 0 && place->second != setting) return false;
  }
  return num_timers > 0;
}

}  // namespace

void MakeScriptTimers(TimerScript* script, VehicleImport* vehicle) {
  const std::vector<std::string> conditions = UsableConditions(*script, *vehicle);
  if (conditions.empty() || !AreTimers(*script)) return;
  for (TimerEvent& event : script->events) {
    const std::string setting(SettingOfEvent(event));
    if (setting.empty()) continue;
    if (event.round == 0) {
      vehicle->AddTimer({.conditions = conditions,
                         .duration_s = event.at_s,
                         .flag = setting,
                         .is_repeated = script->num_resets > 0,
                         .origin = event.origin,
                         .remark = event.assumed.empty() ? "" : "Assumed: " + event.assumed + "."});
    }
    event.keys.clear();
    event.reason = "[[vehicle.behavior]]";
    event.is_needless = true;
  }
  TakeConditions(script);
  std::erase_if(script->losses, [&](const auto& loss) { return loss.first == script->reset_line; });
  if (script->num_resets > 0 && script->num_resets < kEndlessResets) {
    script->losses.emplace_back(script->reset_line,
                                "repeated each time that its conditions have failed, without end");
  }
  if (script->atomic_line > 0) {
    script->losses.emplace_back(script->atomic_line,
                                "its clock stands while its conditions do not hold");
  }
}

}  // namespace shoal
