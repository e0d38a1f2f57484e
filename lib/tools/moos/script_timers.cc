#include "lib/tools/moos/script_timers.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/modes/condition.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/tools/moos/bhv_text.h"

namespace shoal {
namespace {

bool IsOrder(std::string_view name) {
  return name == "DEPLOY" || name == "RETURN" || name == "STATION_KEEP";
}

/// Returns true for a variable that behaviors report by themselves.
bool IsReported(std::string_view name) {
  constexpr std::string_view kBegins[] = {"WPT_",      "CYCLE_",      "LOITER_",   "DIST_TO_",
                                          "PERIODIC_", "PENDING_",    "TIME_AT",   "NAV_X",
                                          "NAV_Y",     "NAV_HEADING", "NAV_SPEED", "NAV_DEPTH"};
  return std::any_of(std::begin(kBegins), std::end(kBegins),
                     [&](std::string_view begin) { return name.starts_with(begin); });
}

/// Returns the argument of `command = "set"` as it stands in TOML; empty: another event.
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
      if (!vehicle.behaviors().variables.contains(name) && !IsReported(name)) return {};
      waits_for_orders_only = waits_for_orders_only && IsOrder(name);
    }
  }
  if (script.is_repeated && waits_for_orders_only) return {};
  return texts;
}

}  // namespace

void MakeScriptTimers(TimerScript* script, VehicleImport* vehicle) {
  const std::vector<std::string> conditions = UsableConditions(*script, *vehicle);
  const auto is_other = [](const TimerEvent& event) {
    return !event.keys.empty() && SettingOfEvent(event).empty();
  };
  const auto sets = [](const TimerEvent& event) { return !SettingOfEvent(event).empty(); };
  const auto& events = script->events;
  if (conditions.empty() || std::any_of(events.begin(), events.end(), is_other) ||
      std::none_of(events.begin(), events.end(), sets)) {
    return;
  }
  for (TimerEvent& event : script->events) {
    const std::string setting(SettingOfEvent(event));
    if (setting.empty()) continue;
    if (event.round == 0) {
      vehicle->AddTimer({.conditions = conditions,
                         .duration_s = event.at_s,
                         .flag = setting,
                         .is_repeated = script->is_repeated,
                         .origin = event.origin,
                         .remark = event.assumed.empty() ? "" : "Assumed: " + event.assumed + "."});
    }
    event.keys.clear();
    event.reason = "[[vehicle.behavior]]";
    event.is_needless = true;
  }
  for (const auto& [line, loss] : script->losses) script->taken.push_back(line);
  script->losses.clear();
}

}  // namespace shoal
