// The tables [[event]] and [[order]].
#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/comms/routing/control.h"
#include "lib/comms/routing/destinations.h"
#include "lib/mission/file/describe.h"

namespace shoal {
namespace {

constexpr size_t kMaxEventValues = 16;

/// A command and the values that it takes, none or these.
struct CommandRule {
  std::string_view command;
  size_t num_values;
  std::string_view values;
  bool values_optional = false;
  size_t most_values = 0;  ///< More than num_values: up to this number may be given.
};

constexpr std::array<CommandRule, 10> kHelmCommands = {{
    {"deploy", 0, ""},
    {"return", 0, ""},
    {"station_keep", 0, ""},
    {"all_stop", 0, ""},
    {"resume", 0, ""},
    {"park", 0, ""},
    {"goto", 2, "[x_m, y_m]"},
    {"speed", 1, "[speed_mps]"},
    {"task", 0, ""},
    {"set", 0, ""},
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
  words.reserve(N);
  for (const CommandRule& rule : rules) words.push_back(rule.command);
  fields.Word(key, command, words);
  fields.Numbers("values", values, kMaxEventValues);
  for (const CommandRule& rule : rules) {
    if (rule.command != command || values.size() == rule.num_values) continue;
    if (rule.values_optional && values.empty()) continue;
    if (values.size() > rule.num_values && values.size() <= rule.most_values) continue;
    fields.Refuse("values", rule.num_values == 0
                                ? fmt::format("{} takes no values", command)
                                : fmt::format("{} needs values = {}", command, rule.values));
  }
}

/// Only `task` takes an argument, a name, and `set`, a variable and its value.
void DescribeArgument(Fields& fields, CommandEvent& event) {
  fields.Text("argument", event.argument, {.max_length = 1000});
  if (event.command == "task") {
    fields.Require("argument", "argument = \"survey\", the name of a task of the vehicle");
  } else if (event.command == "set") {
    fields.Require("argument", "argument = \"RETURN=true\"");
    if (!event.argument.empty() && event.argument.find('=', 1) == std::string::npos) {
      fields.Refuse("argument", "set needs VARIABLE=value, like argument = \"RETURN=true\"");
    }
  } else if (!event.argument.empty()) {
    fields.Refuse("argument", event.command + " takes no argument; only task and set do");
  }
}

void Describe(Fields& fields, CommandEvent& event) {
  fields.Require("vehicle", "vehicle = \"alpha\", \"group:NAME\" or \"all\"");
  fields.Text("vehicle", event.vehicle, {.min_length = 1});
  DescribeCommand(fields, "command", event.command, event.values, kHelmCommands);
  DescribeArgument(fields, event);
  if (event.command == "speed" && event.values.size() == 1 &&
      (event.values[0] <= 0 || event.values[0] > kFastest_mps)) {
    fields.Refuse("values", fmt::format("speed = {} is out of range; allowed: greater than 0, at "
                                        "most {}",
                                        event.values[0], kFastest_mps));
  }
}

void Describe(Fields& fields, SimCommandEvent& event) {
  fields.Require("vehicle", "vehicle = \"alpha\"");
  fields.Text("vehicle", event.vehicle, {.min_length = 1});
  DescribeCommand(fields, "sim_command", event.command, event.values, kSimCommands);
}

void Describe(Fields& fields, RuleEvent& event) {
  std::vector<std::string_view> rules;
  for (const ControlRow& row : ControlTable()) rules.push_back(row.rule);
  fields.Word("rule", event.rule, rules);
  const ControlRow* row = FindControl(event.rule);
  if (row == nullptr) return fields.SkipRest();  // What is right depends on the rule.
  if (fields.Has("vehicle", !event.vehicle.empty()) && !row->of_vehicle) {
    fields.Refuse("vehicle", event.rule + " holds for all, not for one vehicle; leave vehicle out");
  } else if (row->of_vehicle) {
    fields.Require("vehicle", "vehicle = \"alpha\"");
    fields.Text("vehicle", event.vehicle, {.min_length = 1});
  }
  if (row->type == ControlType::kRequest) {
    if (fields.Has("value", false)) fields.Refuse("value", event.rule + " takes no value");
    return;
  }
  fields.Require("value", "value = " + std::string(row->example));
  DescribeControlValue(fields, "value", *row, event.value);
}

void Describe(Fields& fields, MessageEvent& event) {
  constexpr size_t kLongestText = 1'000'000;
  fields.Inline("message", [&](Fields& message) {
    message.Require("src_node", "src_node = \"alpha\"");
    message.Text("src_node", event.src_node, {.min_length = 1});
    message.Text("dest_node", event.dest_node, {.max_length = 10'000});
    message.CalledElsewhere("dest_node", "dest_name");
    message.Text("dest_group", event.dest_group, {});
    const Destinations nodes = ParseDestinations(event.dest_node);
    if (!nodes.all && nodes.names.empty() && event.dest_group.empty()) {
      message.Refuse("dest_node", "a message needs dest_node or dest_group (or both)");
    }
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

void Describe(Fields& fields, Event& event, double end_s) {
  fields.Require("at_s", "at_s = 60");
  fields.Number("at_s", event.at_s, Between(0, end_s));
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
  std::visit([&](auto& what) { Describe(fields, what); }, event.what);
}

void Describe(Fields& fields, NamedOrder& order) {
  fields.Require("name", "name = \"patrol\", which `shoal send patrol` gives");
  fields.Text("name", order.name, {.min_length = 1});
  fields.Require("command", "command = \"set\", as an [[event]] has it");
  if (!fields.Has("command", true)) return fields.SkipRest();
  Describe(fields, order.command);
}

}  // namespace shoal
