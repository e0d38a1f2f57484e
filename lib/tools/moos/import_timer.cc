#include "lib/tools/moos/import_timer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <variant>

#include "lib/base/random/stream.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"
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

/// A line `event = ...`.
struct EventLine {
  int line = 0;
  std::string origin;
  std::string text;
  std::string variable;
  std::string value;
  TimeRange time;
  int amount = 1;
  int first_index = 0;       ///< Of the first of `amount`, for $[IDX].
  std::string problem = {};  ///< Why it is no event.
  bool is_needless = false;
};

/// Returns true where the value stands in double quotes: any other loses its blanks.
bool IsQuotedValue(std::string_view text) {
  const size_t at = text.find("val");
  const size_t equals = at == text.npos ? text.npos : text.find('=', at);
  return equals != text.npos && Trimmed(text.substr(equals + 1)).starts_with('"');
}

EventLine ReadEventLine(const MoosLine& line) {
  constexpr int kMostAmount = 1'000;
  EventLine event{.line = line.number,
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

/// What a script does: its events, and the keys about its rounds.
struct Script {
  std::vector<EventLine> events;
  std::vector<RandomVariable> variables;
  TimeRange delay_start;
  TimeRange delay_reset;
  TimeRange warp = {1, 1};
  std::optional<double> reset_s;  ///< Nothing: when all are posted.
  double num_resets = 0;
  int reset_line = 0;
  int pause_line = 0;  ///< Of paused = true; 0: it is not.
  std::string pause_variable = "UTS_PAUSE";
  bool shuffles = true;  ///< Times are drawn again in each round.
};

Script ReadScript(const MoosBlock& block, TimerScript* result) {
  Script script;
  int index = 0;
  const auto lose = [&](const MoosLine& line, std::string reason) {
    result->losses.emplace_back(line.number, std::move(reason));
  };
  for (const MoosLine& line : block.lines) {
    const std::string key = LowerCase(line.key);
    const std::string value = LowerCase(line.value.substr(0, 32));
    const auto time = ParseTimeRange(value);
    if (key == "event") {
      script.events.push_back(ReadEventLine(line));
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

/// Returns true where an event is one of the mission, or becomes part of something else.
bool IsAnyTaken(const TimerScript& script) {
  return std::any_of(script.events.begin(), script.events.end(), [](const TimerEvent& event) {
    return !event.keys.empty() || event.point || event.drift;
  });
}

class ScriptRun {
 public:
  using Convert =
      std::function<ConvertedEvent(const std::string& posted, const std::string& value)>;

  ScriptRun(const Script& script, std::string_view vehicle, const Convert& convert)
      : script_(script),
        vehicle_(vehicle),
        convert_(convert),
        variables_(script.variables),
        stream_(1, "uTimerScript", vehicle) {}

  void Run(TimerScript* result) {
    for (RandomVariable& variable : variables_) Draw(&variable, &stream_);
    // What a mission without an end lasts (import.cc), and as many events as a person still reads.
    constexpr double kLongest_s = 600;
    constexpr size_t kMostEvents = 500;
    double begin_s = 0;
    for (int round = 0; round <= script_.num_resets; ++round) {
      round_ = round;
      if (round == 0 || script_.shuffles) DrawTimes();
      if (round > 0) {
        for (RandomVariable& variable : variables_) {
          if (variable.key == "at_reset") Draw(&variable, &stream_);
        }
      }
      const double warp = DrawTime(script_.warp, &stream_);
      const TimeRange& delay = round == 0 ? script_.delay_start : script_.delay_reset;
      const double last_s = Round(begin_s, DrawTime(delay, &stream_), warp, result);
      const double length_s = script_.reset_s ? *script_.reset_s : last_s;
      begin_s += length_s / warp;
      const bool goes_on = round < script_.num_resets && !result->events.empty();
      if (!goes_on || !(length_s > 0)) return;
      if (begin_s <= kLongest_s && result->events.size() < kMostEvents) continue;
      if (!IsAnyTaken(*result)) return;  // Its events are lost anyway.
      result->losses.emplace_back(
          script_.reset_line,
          fmt::format("the script is repeated: its {} rounds that begin within {:.0f} s are taken",
                      round + 1, std::min(begin_s, kLongest_s)));
      return;
    }
  }

 private:
  /// One post of a line.
  struct Post {
    const EventLine* event = nullptr;
    int index = 0;
    double time_s = 0;  ///< Of the script's own clock, without its delay.
  };

  void DrawTimes() {
    posts_.clear();
    for (const EventLine& event : script_.events) {
      for (int i = 0; i < event.amount; ++i) {
        posts_.push_back({.event = &event,
                          .index = event.first_index + i,
                          .time_s = DrawTime(event.time, &stream_)});
      }
    }
    std::stable_sort(posts_.begin(), posts_.end(),
                     [](const Post& a, const Post& b) { return a.time_s < b.time_s; });
  }

  /// Adds the events of a round; returns when the last is posted, by the script's clock.
  double Round(double begin_s, double delay_s, double warp, TimerScript* result) {
    double last_s = 0;
    int count = 0;
    for (const Post& post : posts_) {
      const double clock_s = delay_s + post.time_s;
      if (script_.reset_s && script_.num_resets > 0 && clock_s > *script_.reset_s) continue;
      last_s = std::max(last_s, clock_s);
      TimerEvent event{
          .line = post.event->line, .origin = post.event->origin, .text = post.event->text};
      event.round = round_;
      event.at_s = TimerRounded(begin_s + clock_s / warp);
      event.reason = post.event->problem;
      event.is_needless = post.event->is_needless;
      if (event.reason.empty()) AddEvent(post, count, &event);
      if (post.event->problem.empty()) {
        ++count;
        ++total_;
      }
      result->events.push_back(std::move(event));
    }
    return last_s;
  }

  void AddEvent(const Post& post, int count, TimerEvent* event) {
    std::string value = post.event->value;
    std::string variable = post.event->variable;
    bool is_drawn = post.event->time.low_s != post.event->time.high_s;
    const std::string plain = value;
    for (RandomVariable& random : variables_) {
      if (value.find("$[" + random.name + "]") == value.npos &&
          value.find("$(" + random.name + ")") == value.npos) {
        continue;
      }
      if (random.key == "at_post") Draw(&random, &stream_);
      ReplaceTimerMacro(&value, random.name, TomlNumber(random.value));
      is_drawn = true;
    }
    ReplaceTimerMacro(&value, "COUNT", std::to_string(count));
    ReplaceTimerMacro(&value, "TCOUNT", std::to_string(total_));
    ReplaceTimerMacro(&value, "IDX", fmt::format("{:03}", post.index));
    ReplaceTimerMacro(&value, "VNAME", vehicle_.empty() ? "shoreside" : std::string(vehicle_));
    uint64_t limit = 1;
    for (int digits = 1; digits <= 9; ++digits) {
      limit *= 10;
      const std::string macro = std::to_string(digits);
      if (value.find("$(" + macro + ")") == value.npos) continue;
      ReplaceTimerMacro(&value, macro, std::to_string(stream_.UniformInt(limit)));
      is_drawn = true;
    }
    if (value != plain || value.starts_with('{')) value = WithTimerSums(std::move(value));
    if (HasTimerMacro(value) || HasTimerMacro(variable)) {
      event->reason = "holds a macro, which has no value here: write an [[event]] by hand";
      return;
    }
    if (is_drawn) event->assumed = "drawn as uTimerScript draws it, once for all runs";
    ConvertedEvent converted = convert_(variable, value);
    if (auto* keys = std::get_if<EventKeys>(&converted)) {
      event->keys = std::move(*keys);
    } else if (const auto* point = std::get_if<TrackedPoint>(&converted)) {
      event->point = *point;
      event->reason = "[[obstacle]]";
      event->is_needless = true;
    } else if (const auto* drift = std::get_if<DriftChange>(&converted)) {
      event->drift = *drift;
    } else {
      event->reason = std::get<std::string>(converted);
      event->is_needless = event->reason == kOnlyDraws || event->reason == kOnlySounds ||
                           event->reason == kNothingReads;
    }
  }

  const Script& script_;
  std::string_view vehicle_;
  const Convert& convert_;
  std::vector<RandomVariable> variables_;
  Stream stream_;
  std::vector<Post> posts_;
  int round_ = 0;
  int total_ = 0;
};

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
void Unpause(Script* script, TimerScript* result) {
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
  Script script = ReadScript(block, &result);
  if (script.pause_line > 0 && context.may_be_set != nullptr &&
      context.may_be_set(script.pause_variable)) {
    Unpause(&script, &result);
  }
  ScriptRun(script, context.vehicle, convert).Run(&result);
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

bool MoosBridges::Add(const MoosLine& line) {
  if (LowerCase(line.key) != "bridge") return false;
  const auto fields = ParseFields(line.value);
  if (!fields.ok()) return false;
  Bridge bridge;
  for (const MoosField& field : *fields) {
    const std::string key = LowerCase(field.key.substr(0, 16));
    if (key == "src") bridge.source = field.value;
    if (key == "alias") bridge.alias = field.value;
  }
  if (bridge.source.empty()) return false;
  if (bridge.alias.empty()) bridge.alias = bridge.source;
  bridges_.push_back(std::move(bridge));
  return true;
}

std::string MoosBridges::Find(std::string_view posted,
                              std::span<const std::string> vehicles) const {
  for (const Bridge& bridge : bridges_) {
    if (bridge.source == posted) return bridge.alias + "_ALL";
    for (size_t i = 0; i < vehicles.size(); ++i) {
      std::string wanted = bridge.source;
      std::string alias = bridge.alias;
      for (const auto& [macro, value] :
           {std::pair<std::string, std::string>("$N", std::to_string(i + 1)),
            {"$V", UpperCase(vehicles[i])},
            {"$v", LowerCase(vehicles[i])}}) {
        const size_t at = wanted.find(macro);
        if (at != wanted.npos) wanted.replace(at, macro.size(), value);
        const size_t there = alias.find(macro);
        if (there != alias.npos) alias.replace(there, macro.size(), value);
      }
      if (wanted == posted && wanted != bridge.source) return alias + "_" + UpperCase(vehicles[i]);
    }
  }
  return {};
}

}  // namespace shoal
