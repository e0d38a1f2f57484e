#include "lib/tools/moos/import_timer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <variant>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/random/stream.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/control.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/node_message_text.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/import_vehicle.h"

namespace shoal {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

/// Keys of an [[event]], or the reason why there are none.
using Converted = std::variant<Keys, std::string>;

constexpr std::pair<std::string_view, std::string_view> kCommands[] = {
    {"DEPLOY", "deploy"}, {"RETURN", "return"}, {"STATION_KEEP", "station_keep"}};

bool IsOverride(std::string_view variable) {
  return variable.starts_with("MOOS_MANUAL_OVERIDE") ||
         variable.starts_with("MOOS_MANUAL_OVERRIDE");
}

constexpr std::string_view kOnlyDraws = "only draws: the viewer has a way of its own";

bool HasMacro(std::string_view text) {
  return text.find("$[") != text.npos || text.find("$(") != text.npos ||
         text.find("%(") != text.npos || text.find("${") != text.npos;
}

/// "10", or "10:20".
struct TimeRange {
  double low_s = 0;
  double high_s = 0;
};

std::optional<TimeRange> ParseTime(std::string_view text) {
  const size_t colon = text.find(':');
  const auto low = NumberIn(text.substr(0, colon));
  const auto high = colon == text.npos ? low : NumberIn(text.substr(colon + 1));
  if (!low || !high || *low < 0 || *high < *low) return std::nullopt;
  return TimeRange{*low, *high};
}

/// Draws as uTimerScript does, in 10,000 steps.
double DrawUniform(double low, double high, Stream* stream) {
  constexpr uint64_t kSteps = 10'000;
  return low + (high - low) * static_cast<double>(stream->UniformInt(kSteps)) / kSteps;
}

double DrawTime(const TimeRange& range, Stream* stream) {
  return range.low_s == range.high_s ? range.low_s : DrawUniform(range.low_s, range.high_s, stream);
}

/// Drops what sums leave behind the sixth place.
double TimerRounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

/// randvar = varname=X, min=0, max=9, snap=1, key=at_reset
struct RandomVariable {
  std::string name;
  double min = 0;
  double max = 1;
  double snap = 0.001;
  double mu = 0;
  double sigma = 1;
  bool is_gaussian = false;
  std::string key;  ///< at_start, at_reset or at_post: when it is drawn.
  double value = 0;
};

std::optional<RandomVariable> ParseRandomVariable(std::string_view text) {
  const auto fields = ParseFields(text);
  if (!fields.ok()) return std::nullopt;
  RandomVariable variable;
  for (const MoosField& field : *fields) {
    const std::string key = LowerCase(field.key.substr(0, 16));
    const auto number = NumberIn(field.value);
    if (key == "varname") {
      variable.name = field.value;
    } else if (key == "key") {
      variable.key = LowerCase(field.value);
    } else if (key == "type") {
      variable.is_gaussian = LowerCase(field.value) == "gaussian";
    } else if (!number) {
      return std::nullopt;
    } else if (key == "min") {
      variable.min = *number;
    } else if (key == "max") {
      variable.max = *number;
    } else if (key == "snap") {
      variable.snap = *number;
    } else if (key == "mu") {
      variable.mu = *number;
    } else if (key == "sigma") {
      variable.sigma = *number;
    } else {
      return std::nullopt;
    }
  }
  const bool is_drawn =
      variable.key == "at_start" || variable.key == "at_reset" || variable.key == "at_post";
  if (variable.name.empty() || !is_drawn || !(variable.min <= variable.max)) return std::nullopt;
  return variable;
}

void Draw(RandomVariable* variable, Stream* stream) {
  double value = variable->is_gaussian ? variable->mu + variable->sigma * stream->Normal()
                                       : DrawUniform(variable->min, variable->max, stream);
  if (variable->snap > 0) value = std::round(value / variable->snap) * variable->snap;
  if (variable->is_gaussian) value = std::clamp(value, variable->min, variable->max);
  variable->value = TimerRounded(value);
}

/// Computes {a+b}, the innermost pair of braces first, of two numbers each; any other text stays.
std::string WithSums(std::string text) {
  constexpr int kMostPairs = 100;
  for (int i = 0; i < kMostPairs; ++i) {
    const size_t close = text.find('}');
    const size_t open = close == text.npos ? text.npos : text.rfind('{', close);
    if (open == text.npos || text.find('{', close) != text.npos) return text;
    const std::string inner = text.substr(open + 1, close - open - 1);
    std::optional<double> result;
    for (const char sign : std::string_view("*/+-")) {
      const size_t at = inner.find(sign, 1);
      if (at == inner.npos) continue;
      const auto left = NumberIn(std::string_view(inner).substr(0, at));
      const auto right = NumberIn(std::string_view(inner).substr(at + 1));
      if (!left || !right) continue;
      result = sign == '*' ? *left * *right : sign == '+' ? *left + *right : *left - *right;
      if (sign == '/') result = *left / *right;
      break;
    }
    if (!result || !std::isfinite(*result)) return text;
    text.replace(open, close - open + 1, TomlNumber(TimerRounded(*result)));
  }
  return text;
}

void Replace(std::string* text, const std::string& macro, const std::string& value) {
  for (const std::string& form : {"$[" + macro + "]", "$(" + macro + ")"}) {
    for (size_t at = text->find(form); at != text->npos; at = text->find(form, at + value.size())) {
      text->replace(at, form.size(), value);
    }
  }
}

class EventConverter {
 public:
  EventConverter(std::string_view vehicle, std::span<const std::string> vehicles,
                 const HasMoosVariable& has_variable, const FindMoosBridge& find_bridge)
      : vehicle_(vehicle),
        vehicles_(vehicles),
        has_variable_(has_variable),
        find_bridge_(find_bridge) {}

  Converted Convert(const std::string& posted, const std::string& value) const {
    if (posted.starts_with("VIEW_")) return std::string(kOnlyDraws);
    const bool may_be_bridged = vehicle_.empty() && find_bridge_ != nullptr;
    const std::string bridged = may_be_bridged ? find_bridge_(posted) : "";
    const std::string& variable = bridged.empty() ? posted : bridged;
    for (const auto& [name, command] : kCommands) {
      if (LowerCase(value) != "true" && IsVariable(variable, name)) break;
      if (const auto target = TargetOf(variable, name)) return CommandOf(*target, command, value);
    }
    for (const std::string_view name : {"MOOS_MANUAL_OVERIDE", "MOOS_MANUAL_OVERRIDE"}) {
      if (const auto target = TargetOf(variable, name)) return CommandOf(*target, "park", value);
    }
    if (const auto target = TargetOf(variable, "DRIFT_VECTOR")) return DriftOf(*target, value);
    if (const ControlRow* row = FindControlOnChannel(variable)) return RuleOf(*row, value);
    const bool is_mediated = variable.starts_with(topics::kMediatedMessage);
    if (is_mediated || variable == topics::kNodeMessageLocal || variable == topics::kNodeMessage) {
      return MessageOf(is_mediated, value);
    }
    return SettingOf(variable, value);
  }

 private:
  bool HasVariable(std::string_view vehicle, std::string_view variable) const {
    return has_variable_ != nullptr && has_variable_(vehicle, variable);
  }

  bool AnyHasVariable(std::string_view variable) const {
    return std::any_of(vehicles_.begin(), vehicles_.end(),
                       [&](const std::string& vehicle) { return HasVariable(vehicle, variable); });
  }

  /// Returns true where `posted` sets the variable `name` of behaviors.
  bool IsVariable(std::string_view posted, std::string_view name) const {
    const auto target = TargetOf(posted, name);
    return target && (*target == "all" ? AnyHasVariable(name) : HasVariable(*target, name));
  }

  /// A variable of behaviors: of the vehicle's own file, or with _ALL or _ABE of the shore's.
  Converted SettingOf(std::string_view posted, const std::string& value) const {
    std::string_view name = posted;
    if (vehicle_.empty() || !HasVariable(vehicle_, name)) {
      name = posted.substr(0, std::min(posted.rfind('_'), posted.size()));
    }
    while (!name.empty() && !IsVariable(posted, name)) {
      const size_t end = name.rfind('_');  // A vehicle's name may hold '_'.
      name = name.substr(0, end == name.npos ? 0 : end);
    }
    if (name.empty()) return "no counterpart in shoal";
    return Keys{{"vehicle", TomlString(*TargetOf(posted, name))},
                {"command", TomlString("set")},
                {"argument", TomlString(fmt::format("{}={}", name, value))}};
  }

  /// Returns the vehicle that `variable` is for: DEPLOY of its own file, DEPLOY_ALL and DEPLOY_ABE
  /// of the shore's.
  std::optional<std::string> TargetOf(std::string_view variable, std::string_view name) const {
    if (!variable.starts_with(name)) return std::nullopt;
    const std::string_view suffix = variable.substr(name.size());
    if (suffix.empty()) {
      return vehicle_.empty() ? std::nullopt : std::optional<std::string>(vehicle_);
    }
    if (!suffix.starts_with('_')) return std::nullopt;
    const std::string wanted = LowerCase(suffix.substr(1));
    if (wanted == "all") return "all";
    for (const std::string& each : vehicles_) {
      if (LowerCase(each) == wanted) return each;
    }
    return std::nullopt;
  }

  static Converted CommandOf(const std::string& vehicle, std::string_view command,
                             const std::string& value) {
    if (LowerCase(value) != "true") {
      return "only true has a counterpart; deploy, park and station_keep are commands here";
    }
    return Keys{{"vehicle", TomlString(vehicle)}, {"command", TomlString(command)}};
  }

  static Converted DriftOf(const std::string& vehicle, std::string_view value) {
    constexpr char kNoDrift[] = "not a vehicle's ANGLE,SPEED";
    const size_t comma = value.find(',');
    const auto angle_deg = NumberIn(value.substr(0, comma));
    if (vehicle == "all" || !angle_deg || comma == value.npos) return kNoDrift;
    const auto speed_mps = NumberIn(value.substr(comma + 1));
    if (!speed_mps) return kNoDrift;
    const double angle_rad = *angle_deg * std::numbers::pi / 180;
    const auto rounded = [](double number) { return std::round(number * 1e9) / 1e9 + 0.0; };
    return Keys{{"vehicle", TomlString(vehicle)},
                {"sim_command", TomlString("drift")},
                {"values", fmt::format("[{}, {}]", TomlNumber(rounded(*speed_mps * Sin(angle_rad))),
                                       TomlNumber(rounded(*speed_mps * Cos(angle_rad))))}};
  }

  static Converted RuleOf(const ControlRow& row, const std::string& value) {
    Keys keys = {{"rule", TomlString(row.rule)}};
    std::string word = value;
    if (row.type == ControlType::kRequest) {
      keys.emplace_back("vehicle", TomlString(value));
      return keys;
    }
    if (row.of_vehicle) {
      const auto factor =
          ParseLinkFactor({.text = "", .key = std::string(row.rule), .value = value});
      if (!factor) return fmt::format("not vname=NAME, {}=NUMBER", row.rule);
      keys.emplace_back("vehicle", TomlString(factor->vehicle));
      keys.emplace_back("value", factor->value);
      return keys;
    }
    const auto number = NumberIn(value);
    const std::string lower = LowerCase(value);
    if (number) word = TomlNumber(*number);
    if (!number) word = lower == "true" || lower == "false" ? lower : TomlString(value);
    keys.emplace_back("value", word);
    return keys;
  }

  static Converted MessageOf(bool is_mediated, std::string_view value) {
    const Result<MoosNodeMessage> message = ParseNodeMessage(value);
    if (!message.ok()) return message.error();
    std::string text;
    const auto add = [&](std::string_view key, const std::string& written) {
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key, written);
    };
    add("src_node", TomlString(message->src_node));
    if (!message->dest_node.empty()) add("dest_node", TomlString(message->dest_node));
    if (!message->dest_group.empty()) add("dest_group", TomlString(message->dest_group));
    add("var_name", TomlString(message->var_name));
    if (message->double_val) {
      add("double_val", TomlNumber(*message->double_val));
    } else {
      add("string_val", TomlString(message->string_val));
    }
    if (message->ack || is_mediated) add("ack", "true");
    return Keys{{"message", "{" + text + "}"}};
  }

  std::string_view vehicle_;
  std::span<const std::string> vehicles_;
  const HasMoosVariable& has_variable_;
  const FindMoosBridge& find_bridge_;
};

/// A line `event = ...`.
struct EventLine {
  int line = 0;
  std::string origin;
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
  EventLine event{
      .line = line.number, .origin = line.origin, .variable = "", .value = "", .time = {}};
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
    const auto time = key == "time" ? ParseTime(field.value) : std::nullopt;
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
  bool is_paused = false;
  bool shuffles = true;  ///< Times are drawn anew in each round.
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
    const auto time = ParseTime(value);
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
      if (time) script.reset_s = (time->low_s + time->high_s) / 2;
      result->taken.push_back(line.number);
    } else if (key == "reset_max") {
      const auto number = NumberIn(value);
      script.num_resets = number.value_or(1e9);
      script.reset_line = line.number;
      result->taken.push_back(line.number);
    } else if (key == "shuffle") {
      script.shuffles = value != "false";
      result->taken.push_back(line.number);
    } else if (key == "paused" && value == "true") {
      script.is_paused = true;
      lose(line, "the script waits until a message starts it: its events are not taken");
    } else if (key == "condition") {
      lose(line, "taken as if it held from the start");
    } else if (key == "upon_awake") {
      result->taken.push_back(line.number);  // Conditions hold from the start.
    }
  }
  return script;
}

class ScriptRun {
 public:
  ScriptRun(const Script& script, std::string_view vehicle, const EventConverter& converter)
      : script_(script),
        vehicle_(vehicle),
        converter_(converter),
        variables_(script.variables),
        stream_(1, "uTimerScript", vehicle) {}

  void Run(TimerScript* result) {
    for (RandomVariable& variable : variables_) Draw(&variable, &stream_);
    // What a mission without an end lasts (import.cc), and as many events as a person still reads.
    constexpr double kLongest_s = 600;
    constexpr size_t kMostEvents = 500;
    double begin_s = 0;
    for (int round = 0; round <= script_.num_resets; ++round) {
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
      const bool any = std::any_of(result->events.begin(), result->events.end(),
                                   [](const TimerEvent& event) { return !event.keys.empty(); });
      if (!any) return;  // Its events are lost anyway.
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
      TimerEvent event{.line = post.event->line, .origin = post.event->origin};
      event.at_s = TimerRounded(begin_s + clock_s / warp);
      event.reason = post.event->problem;
      event.is_needless = post.event->is_needless;
      if (event.reason.empty()) Convert(post, count, &event);
      if (post.event->problem.empty()) {
        ++count;
        ++total_;
      }
      result->events.push_back(std::move(event));
    }
    return last_s;
  }

  void Convert(const Post& post, int count, TimerEvent* event) {
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
      Replace(&value, random.name, TomlNumber(random.value));
      is_drawn = true;
    }
    Replace(&value, "COUNT", std::to_string(count));
    Replace(&value, "TCOUNT", std::to_string(total_));
    Replace(&value, "IDX", fmt::format("{:03}", post.index));
    Replace(&value, "VNAME", vehicle_.empty() ? "shoreside" : std::string(vehicle_));
    uint64_t limit = 1;
    for (int digits = 1; digits <= 9; ++digits) {
      limit *= 10;
      const std::string macro = std::to_string(digits);
      if (value.find("$(" + macro + ")") == value.npos) continue;
      Replace(&value, macro, std::to_string(stream_.UniformInt(limit)));
      is_drawn = true;
    }
    if (value != plain || value.starts_with('{')) value = WithSums(std::move(value));
    if (HasMacro(value) || HasMacro(variable)) {
      event->reason = "holds a macro, which has no value here: write an [[event]] by hand";
      return;
    }
    if (is_drawn) event->assumed = "drawn as uTimerScript draws it, once for all runs";
    Converted converted = converter_.Convert(variable, value);
    if (auto* keys = std::get_if<Keys>(&converted)) {
      event->keys = std::move(*keys);
    } else {
      event->reason = std::get<std::string>(converted);
      event->is_needless = event->reason == kOnlyDraws;
    }
  }

  const Script& script_;
  std::string_view vehicle_;
  const EventConverter& converter_;
  std::vector<RandomVariable> variables_;
  Stream stream_;
  std::vector<Post> posts_;
  int total_ = 0;
};

}  // namespace

TimerScript ReadTimerScript(const MoosBlock& block, std::string_view vehicle,
                            std::span<const std::string> vehicles,
                            const HasMoosVariable& has_variable,
                            const FindMoosBridge& find_bridge) {
  const EventConverter converter(vehicle, vehicles, has_variable, find_bridge);
  TimerScript result;
  const Script script = ReadScript(block, &result);
  ScriptRun(script, vehicle, converter).Run(&result);
  for (TimerEvent& event : result.events) {
    if (!script.is_paused || event.keys.empty()) continue;
    event.keys.clear();
    event.reason = "the script is paused";
    event.is_needless = true;
  }
  return result;
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
