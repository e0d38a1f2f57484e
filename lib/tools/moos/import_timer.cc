#include "lib/tools/moos/import_timer.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/script_run.h"
#include "lib/tools/moos/sim_drift.h"
#include "lib/tools/moos/timer_draws.h"
#include "lib/tools/moos/timer_events.h"

namespace shoal {
namespace {

/// What becomes of a condition.
constexpr std::string_view kTakenAsHeld = "taken as if it held from the start";
/// What becomes of a script that is paused.
constexpr std::string_view kWaits =
    "the script waits until a message starts it: its events are not taken";

bool IsOverride(std::string_view variable) {
  return variable.starts_with("MOOS_MANUAL_OVERIDE") ||
         variable.starts_with("MOOS_MANUAL_OVERRIDE");
}

/// Returns true where the value is in double quotes: any other loses its blanks.
bool IsQuotedValue(std::string_view text) {
  const size_t at = text.find("val");
  const size_t equals = at == text.npos ? text.npos : text.find('=', at);
  return equals != text.npos && Trimmed(text.substr(equals + 1)).starts_with('"');
}

ScriptLine ReadScriptLine(const MoosLine& line) {
  constexpr int kMostAmount = 1'000;
  ScriptLine event{.line = line.number,
                   .origin = line.origin,
                   .text = line.text,
                   .variable = "",
                   .value = "",
                   .time = {}};
  if (LowerCase(line.value) == "quit") {
    event.problem = "a script needs no end here";
    event.is_needless = true;
    return event;
  }
  const auto fields = ParseFields(line.value);
  if (!fields.ok()) {
    event.problem = fields.error();
    return event;
  }
  for (const MoosField& field : *fields) {
    const std::string key = LowerCase(field.key.substr(0, 16));
    const auto time = key == "time" ? ParseTimeRange(field.value) : std::nullopt;
    const double amount = key == "amt" ? NumberIn(field.value).value_or(-1) : -1;
    if (key == "var") {
      event.variable = field.value;
    } else if (key == "val") {
      event.value = field.value;
      if (!IsQuotedValue(line.value)) std::erase(event.value, ' ');
    } else if (time) {
      event.time = *time;
    } else if (amount >= 0 && amount <= kMostAmount) {
      event.amount = std::max(1, static_cast<int>(amount));
    } else {
      event.problem = fmt::format("{} makes no sense; write var=NAME, val=VALUE, time=SECONDS",
                                  Quoted(field.key + "=" + field.value));
      return event;
    }
  }
  if (IsOverride(event.variable) && LowerCase(event.value) == "false") {
    event.problem = "the command deploy does this too";
    event.is_needless = true;
  }
  return event;
}

MoosScript ReadScript(const MoosBlock& block, TimerScript* result) {
  MoosScript script;
  int index = 0;
  const auto lose = [&](const MoosLine& line, std::string reason) {
    result->losses.emplace_back(line.number, std::move(reason));
  };
  for (const MoosLine& line : block.lines) {
    const std::string key = LowerCase(line.key);
    const std::string value = LowerCase(line.value.substr(0, 32));
    const auto time = ParseTimeRange(value);
    if (key == "event") {
      script.events.push_back(ReadScriptLine(line));
      script.events.back().first_index = index;
      index += script.events.back().amount;
    } else if (key == "randvar" || key == "rand_var") {
      if (const auto variable = ParseRandomVariable(line.value)) {
        script.variables.push_back(*variable);
        result->taken.push_back(line.number);
      } else {
        lose(line, "not varname=X, min=0, max=9, key=at_start, at_reset or at_post");
      }
    } else if (key == "delay_start" || key == "start_delay" || key == "delay_reset") {
      if (!time) {
        lose(line, "not SECONDS or LOW:HIGH");
        continue;
      }
      (key == "delay_reset" ? script.delay_reset : script.delay_start) = *time;
      result->taken.push_back(line.number);
    } else if (key == "time_warp") {
      if (!time || time->low_s <= 0) {
        lose(line, "not a positive number");
        continue;
      }
      script.warp = *time;
      result->taken.push_back(line.number);
    } else if (key == "reset_time") {
      if (!time && value != "all-posted" && value != "end" && value != "none") {
        lose(line, "not SECONDS, all-posted or none");
        continue;
      }
      if (time) script.reset_s = (time->low_s + time->high_s) / 2;
      result->taken.push_back(line.number);
    } else if (key == "reset_max") {
      const auto number = NumberIn(value);
      const bool is_endless = value == "nolimit" || value == "unlimited" || value == "any";
      if (!is_endless && (!number || *number < 0)) {
        lose(line, "not a number from 0 on or nolimit");
        continue;
      }
      script.num_resets = number.value_or(kEndlessResets);
      script.reset_line = line.number;
      result->taken.push_back(line.number);
    } else if (key == "script_atomic" && value == "true") {
      result->atomic_line = line.number;
      result->taken.push_back(line.number);
    } else if (key == "shuffle") {
      script.shuffles = value != "false";
      result->taken.push_back(line.number);
    } else if (key == "paused" && value == "true") {
      script.pause_line = line.number;
      lose(line, std::string(kWaits));
    } else if (key == "pause_var") {
      script.pause_variable = line.value;
      result->taken.push_back(line.number);
    } else if (key == "condition") {
      result->conditions.emplace_back(line.value);
      lose(line, std::string(kTakenAsHeld));
    } else if (key == "upon_awake") {
      result->taken.push_back(line.number);  // Conditions hold from the start.
    }
  }
  return script;
}

/// Gives each change of a drift the keys of the drift that is there then.
void SumDrifts(const TimerContext& context, TimerScript* script) {
  std::vector<TimerEvent*> changes;
  for (TimerEvent& event : script->events) {
    if (event.drift) changes.push_back(&event);
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const TimerEvent* a, const TimerEvent* b) { return a->at_s < b->at_s; });
  std::map<std::string, Eigen::Vector2d> drifts_mps;
  for (TimerEvent* event : changes) {
    const std::string& vehicle = event->drift->vehicle;
    const Eigen::Vector2d first_mps = context.first_drift_mps == nullptr
                                          ? Eigen::Vector2d(0, 0)
                                          : context.first_drift_mps(vehicle);
    Eigen::Vector2d& drift_mps = drifts_mps.emplace(vehicle, first_mps).first->second;
    drift_mps = DriftAfter(drift_mps, *event->drift);
    event->keys = {
        {"vehicle", TomlString(vehicle)},
        {"sim_command", TomlString("drift")},
        {"values", fmt::format("[{}, {}]", TomlNumber(drift_mps.x()), TomlNumber(drift_mps.y()))}};
  }
}

/// A script that behaviors start waits for its variable.
void Unpause(MoosScript* script, TimerScript* result) {
  result->conditions.push_back(script->pause_variable + " = false");
  std::erase_if(result->losses, [&](const auto& loss) { return loss.first == script->pause_line; });
  result->taken.push_back(script->pause_line);
  script->pause_line = 0;
}

/// The script does not run: nothing is lost of it but where it `waits`.
void LeaveOut(const std::string& reason, bool waits, TimerScript* script) {
  std::erase_if(script->losses, [&](const auto& loss) {
    if (waits && loss.second == kWaits) return false;
    script->taken.push_back(loss.first);
    return true;
  });
  for (TimerEvent& event : script->events) {
    event.keys.clear();
    event.point.reset();
    event.drift.reset();
    event.reason = reason;
    event.is_needless = true;
  }
}

}  // namespace

TimerScript ReadTimerScript(const MoosBlock& block, const TimerContext& context) {
  const auto convert = [&](const std::string& posted, const std::string& value) {
    return ConvertEvent(posted, value, context);
  };
  TimerScript result;
  MoosScript script = ReadScript(block, &result);
  if (script.pause_line > 0 && context.may_be_set != nullptr &&
      context.may_be_set(script.pause_variable)) {
    Unpause(&script, &result);
  }
  RunScript(script, context.vehicle, convert, &result);
  result.num_resets = script.num_resets;
  result.reset_line = script.reset_line;
  const bool is_idle = script.pause_line > 0 || !context.idle.empty();
  // What is lost then are its events, whatever its conditions.
  if (!IsAnyTaken(result) || is_idle) TakeConditions(&result);
  if (is_idle) {
    const bool is_paused = context.idle.empty();
    LeaveOut(is_paused ? "the script is paused" : context.idle, is_paused, &result);
  } else {
    SumDrifts(context, &result);
  }
  return result;
}

void TakeConditions(TimerScript* script) {
  std::erase_if(script->losses, [&](const auto& loss) {
    if (loss.second != kTakenAsHeld) return false;
    script->taken.push_back(loss.first);
    return true;
  });
}

}  // namespace shoal
