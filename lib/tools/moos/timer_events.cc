#include "lib/tools/moos/timer_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/control.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/node_message_text.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/link_factor.h"

namespace shoal {

namespace {

constexpr std::pair<std::string_view, std::string_view> kCommands[] = {
    {"DEPLOY", "deploy"}, {"RETURN", "return"}, {"STATION_KEEP", "station_keep"}};

class EventConverter {
 public:
  explicit EventConverter(const TimerContext& context)
      : context_(context), vehicle_(context.vehicle), vehicles_(context.vehicles) {}

  ConvertedEvent Convert(const std::string& posted, const std::string& value) const {
    if (posted.starts_with("VIEW_")) return std::string(kOnlyDraws);
    if (posted == "SAY_MOOS") return std::string(kOnlySounds);
    const bool may_be_bridged = vehicle_.empty() && context_.find_bridge != nullptr;
    const std::string bridged = may_be_bridged ? context_.find_bridge(posted) : "";
    const std::string& variable = bridged.empty() ? posted : bridged;
    for (const auto& [name, command] : kCommands) {
      if (LowerCase(value) != "true" && IsVariable(variable, name)) break;
      if (const auto target = TargetOf(variable, name)) return CommandOf(*target, command, value);
    }
    for (const std::string_view name : {"MOOS_MANUAL_OVERIDE", "MOOS_MANUAL_OVERRIDE"}) {
      if (const auto target = TargetOf(variable, name)) return CommandOf(*target, "park", value);
    }
    for (const std::string_view name : DriftVariables()) {
      const auto target = TargetOf(variable, name);
      if (target) return DriftOf(*target, *DriftActionOf(name), value);
    }
    for (const std::string& name : context_.point_variables) {
      if (posted == name || TargetOf(variable, name)) return PointOf(value);
    }
    if (const ControlRow* row = FindControlOnChannel(variable)) return RuleOf(*row, value);
    const bool is_mediated = variable.starts_with(topics::kMediatedMessage);
    if (is_mediated || variable == topics::kNodeMessageLocal || variable == topics::kNodeMessage) {
      return MessageOf(is_mediated, value);
    }
    return SettingOf(variable, value);
  }

 private:
  bool HasVariable(std::string_view vehicle, std::string_view variable) const {
    return context_.has_variable != nullptr && context_.has_variable(vehicle, variable);
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
  ConvertedEvent SettingOf(std::string_view posted, const std::string& value) const {
    std::string_view name = posted;
    if (vehicle_.empty() || !HasVariable(vehicle_, name)) {
      name = posted.substr(0, std::min(posted.rfind('_'), posted.size()));
    }
    while (!name.empty() && !IsVariable(posted, name)) {
      const size_t end = name.rfind('_');  // A vehicle's name may hold '_'.
      name = name.substr(0, end == name.npos ? 0 : end);
    }
    if (name.empty()) {
      const bool is_read = context_.may_be_read == nullptr || context_.may_be_read(posted);
      return is_read ? "no counterpart in shoal" : std::string(kNothingReads);
    }
    return EventKeys{{"vehicle", TomlString(*TargetOf(posted, name))},
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

  static ConvertedEvent CommandOf(const std::string& vehicle, std::string_view command,
                                  const std::string& value) {
    if (LowerCase(value) != "true") {
      return "only true has a counterpart; deploy, park and station_keep are commands here";
    }
    return EventKeys{{"vehicle", TomlString(vehicle)}, {"command", TomlString(command)}};
  }

  static ConvertedEvent DriftOf(const std::string& vehicle, DriftAction action,
                                std::string_view value) {
    const auto drift_mps = ParseDriftValue(action, value);
    const bool is_vector = action == DriftAction::kSet || action == DriftAction::kAdd;
    if (vehicle == "all" || !drift_mps) {
      return is_vector ? "not a vehicle's ANGLE,SPEED" : "not a vehicle's number";
    }
    return DriftChange{.vehicle = vehicle, .action = action, .drift_mps = *drift_mps};
  }

  /// "x=23,y=99,label=b".
  static ConvertedEvent PointOf(std::string_view value) {
    TrackedPoint point;
    std::optional<double> x_m;
    std::optional<double> y_m;
    for (const std::string_view part : TrimmedParts(value, ',')) {
      const size_t equals = std::min(part.find('='), part.size());
      const std::string_view key = Trimmed(part.substr(0, equals));
      const std::string_view text = Trimmed(part.substr(std::min(equals + 1, part.size())));
      if (key == "x") x_m = NumberIn(text);
      if (key == "y") y_m = NumberIn(text);
      if (key == "label" || key == "key") point.label = text;
    }
    if (!x_m || !y_m || point.label.empty()) return "not x=NUMBER,y=NUMBER,label=NAME";
    point.position_m = {*x_m, *y_m};
    return point;
  }

  static ConvertedEvent RuleOf(const ControlRow& row, const std::string& value) {
    EventKeys keys = {{"rule", TomlString(row.rule)}};
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

  static ConvertedEvent MessageOf(bool is_mediated, std::string_view value) {
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
    return EventKeys{{"message", "{" + text + "}"}};
  }

  const TimerContext& context_;
  std::string_view vehicle_;
  std::span<const std::string> vehicles_;
};

}  // namespace

ConvertedEvent ConvertEvent(const std::string& posted, const std::string& value,
                            const TimerContext& context) {
  return EventConverter(context).Convert(posted, value);
}

}  // namespace shoal
