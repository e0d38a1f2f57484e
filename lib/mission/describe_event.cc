// The table [[event]].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/mission/describe.h"
#include "lib/mission/suggest.h"
#include "lib/routing/control.h"
#include "lib/routing/destinations.h"

namespace shoal {
namespace {

constexpr size_t kMostEventValues = 16;

/// A command and the values that it takes, none or these.
struct CommandRule {
  std::string_view command;
  size_t num_values;
  std::string_view values;
  bool values_optional = false;
  size_t most_values = 0;  ///< More than num_values: so many may be given.
};

constexpr std::array<CommandRule, 9> kHelmCommands = {{
    {"deploy", 0, ""},
    {"return", 0, ""},
    {"station_keep", 0, ""},
    {"all_stop", 0, ""},
    {"resume", 0, ""},
    {"park", 0, ""},
    {"goto", 2, "[x_m, y_m]"},
    {"speed", 1, "[speed_mps]"},
    {"task", 0, ""},
}};

constexpr std::array<CommandRule, 4> kSimCommands = {{
    {"pause", 0, ""},
    {"resume", 0, ""},
    {"reset", 4, "[x_m, y_m, heading_deg, speed_mps]", true, 5},
    {"drift", 2, "[x_mps, y_mps]"},
}};

template <size_t N>
void DescribeCommand(Fields& fields, std::string_view key, std::string& command,
                     std::vector<double>& values, const std::array<CommandRule, N>& rules) {
  std::vector<std::string_view> words;
  for (const CommandRule& rule : rules) words.push_back(rule.command);
  fields.Word(key, command, words);
  fields.Numbers("values", values, kMostEventValues);
  for (const CommandRule& rule : rules) {
    if (rule.command != command || values.size() == rule.num_values) continue;
    if (rule.values_optional && values.empty()) continue;
    if (values.size() > rule.num_values && values.size() <= rule.most_values) continue;
    fields.Refuse("values", rule.num_values == 0
                                ? fmt::format("{} takes no values", command)
                                : fmt::format("{} needs values = {}", command, rule.values));
  }
}

/// The argument of `task`: a task that every vehicle it is said to has.
void CheckTaskArgument(Fields& fields, const CommandEvent& event, const Mission& mission) {
  if (event.command != "task") {
    if (!event.argument.empty()) {
      fields.Refuse("argument", event.command + " takes no argument; only task does");
    }
    return;
  }
  fields.Require("argument", "argument = \"survey\", the name of a task of the vehicle");
  if (event.argument.empty()) return;
  for (const Vehicle* vehicle : VehiclesNamed(mission, event.vehicle)) {
    std::vector<std::string_view> names;
    for (const Task& task : vehicle->tasks) names.push_back(task.name);
    if (std::find(names.begin(), names.end(), event.argument) != names.end()) continue;
    fields.Refuse("argument",
                  fmt::format("{} has no task {}{}", vehicle->name, Quoted(event.argument),
                              DidYouMean(event.argument, names)));
    return;
  }
}

void Describe(Fields& fields, CommandEvent& event, const Mission& mission) {
  fields.Require("vehicle", "vehicle = \"alpha\", or \"all\"");
  fields.Text("vehicle", event.vehicle, {.min_length = 1});
  ResolveVehicle(fields, "vehicle", event.vehicle, mission, true);
  DescribeCommand(fields, "command", event.command, event.values, kHelmCommands);
  fields.Text("argument", event.argument, {});
  CheckTaskArgument(fields, event, mission);
  if (event.command == "speed" && event.values.size() == 1 &&
      (event.values[0] <= 0 || event.values[0] > kFastest_mps)) {
    fields.Refuse("values", fmt::format("speed = {} is out of range; allowed: greater than 0, at "
                                        "most {}",
                                        event.values[0], kFastest_mps));
  }
}

void Describe(Fields& fields, SimCommandEvent& event, const Mission& mission) {
  fields.Require("vehicle", "vehicle = \"alpha\"");
  fields.Text("vehicle", event.vehicle, {.min_length = 1});
  ResolveVehicle(fields, "vehicle", event.vehicle, mission, true);
  DescribeCommand(fields, "sim_command", event.command, event.values, kSimCommands);
}

void Describe(Fields& fields, RuleEvent& event, const Mission& mission) {
  std::vector<std::string_view> rules;
  for (const ControlRow& row : ControlTable()) rules.push_back(row.rule);
  fields.Word("rule", event.rule, rules);
  const ControlRow* row = FindControl(event.rule);
  if (row == nullptr) return fields.SkipRest();  // Without the rule, nobody knows what is right.
  if (fields.Has("vehicle", !event.vehicle.empty()) && !row->of_vehicle) {
    fields.Refuse("vehicle", event.rule + " holds for all, not for one vehicle; leave vehicle out");
  } else if (row->of_vehicle) {
    fields.Require("vehicle", "vehicle = \"alpha\"");
    fields.Text("vehicle", event.vehicle, {.min_length = 1});
    ResolveVehicle(fields, "vehicle", event.vehicle, mission, false);
  }
  if (row->type == ControlType::kRequest) {
    if (fields.Has("value", false)) fields.Refuse("value", event.rule + " takes no value");
    return;
  }
  fields.Require("value", "value = " + std::string(row->example));
  DescribeControlValue(fields, "value", *row, event.value);
}

/// What `dest_node` names must be vehicles of the mission: others can never be reached. A group may
/// have members that come from outside.
void CheckDestinations(Fields& fields, const MessageEvent& event, const Mission& mission) {
  const Destinations nodes = ParseDestinations(event.dest_node);
  if (!nodes.all && nodes.names.empty() && event.dest_group.empty()) {
    fields.Refuse("dest_node", "a message needs dest_node or dest_group (or both)");
  }
  for (std::string name : nodes.names) {
    ResolveVehicle(fields, "dest_node", name, mission, true);
  }
  const std::string group = LowerCase(event.dest_group);
  if (group.empty() || group == "all") return;
  std::vector<std::string_view> groups;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (LowerCase(vehicle.group) == group) return;
    if (!vehicle.group.empty()) groups.push_back(vehicle.group);
  }
  fields.Warn("dest_group",
              fmt::format("no vehicle of the mission is of group {}{}", Quoted(event.dest_group),
                          DidYouMean(event.dest_group, groups)));
}

void Describe(Fields& fields, MessageEvent& event, const Mission& mission) {
  constexpr size_t kLongestText = 1'000'000;
  fields.Inline("message", [&](Fields& message) {
    message.Require("src_node", "src_node = \"alpha\"");
    message.Text("src_node", event.src_node, {.min_length = 1});
    ResolveVehicle(message, "src_node", event.src_node, mission, false);
    message.Text("dest_node", event.dest_node, {.max_length = 10'000});
    message.Text("dest_group", event.dest_group, {});
    CheckDestinations(message, event, mission);
    message.Require("var_name", "var_name = \"UPDATE_LOITER\"");
    message.Text("var_name", event.var_name, {.min_length = 1});
    message.Text("string_val", event.string_val, {.max_length = kLongestText, .many_lines = true});
    if (message.Has("double_val", event.double_val.has_value())) {
      double value = event.double_val.value_or(0);
      message.Number("double_val", value, Between(-1e300, 1e300));
      event.double_val = value;
      if (!event.string_val.empty()) {
        message.Refuse("double_val", "a message has string_val or double_val, not both");
      }
    }
    message.Flag("ack", event.ack);
  });
}

}  // namespace

void Describe(Fields& fields, Event& event, const Mission& mission) {
  fields.Require("at_s", "at_s = 60");
  fields.Number("at_s", event.at_s,
                Between(0, mission.duration_s > 0 ? mission.duration_s : kLongest_s));
  const bool command = fields.Has("command", std::holds_alternative<CommandEvent>(event.what));
  const bool sim = fields.Has("sim_command", std::holds_alternative<SimCommandEvent>(event.what));
  const bool rule = fields.Has("rule", std::holds_alternative<RuleEvent>(event.what));
  const bool message = fields.Has("message", std::holds_alternative<MessageEvent>(event.what));
  if (command + sim + rule + message != 1) {
    fields.Refuse("", "an event needs one of command, sim_command, rule and message, and only one");
    fields.SkipRest();
    return;
  }
  if (fields.reading()) {
    if (sim) event.what = SimCommandEvent();
    if (rule) event.what = RuleEvent();
    if (message) event.what = MessageEvent();
  }
  std::visit([&](auto& what) { Describe(fields, what, mission); }, event.what);
}

}  // namespace shoal
