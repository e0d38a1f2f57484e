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

namespace shoal {
namespace {

constexpr size_t kMostValues = 16;

/// A command and the values that it takes, none or these.
struct CommandRule {
  std::string_view command;
  size_t num_values;
  std::string_view values;
  bool values_optional = false;
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
    {"reset", 4, "[x_m, y_m, heading_deg, speed_mps]", true},
    {"drift", 2, "[x_mps, y_mps]"},
}};

template <size_t N>
void DescribeCommand(Fields& fields, std::string_view key, std::string& command,
                     std::vector<double>& values, const std::array<CommandRule, N>& rules) {
  std::vector<std::string_view> words;
  for (const CommandRule& rule : rules) words.push_back(rule.command);
  fields.Word(key, command, words);
  fields.Numbers("values", values, kMostValues);
  for (const CommandRule& rule : rules) {
    if (rule.command != command || values.size() == rule.num_values) continue;
    if (rule.values_optional && values.empty()) continue;
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
}

void Describe(Fields& fields, SimCommandEvent& event, const Mission& mission) {
  fields.Require("vehicle", "vehicle = \"alpha\"");
  fields.Text("vehicle", event.vehicle, {.min_length = 1});
  ResolveVehicle(fields, "vehicle", event.vehicle, mission, true);
  DescribeCommand(fields, "sim_command", event.command, event.values, kSimCommands);
}

void Describe(Fields& fields, RuleEvent& event, const Mission& mission) {
  constexpr std::array<std::string_view, 2> kRules = {"comms_range", "stale_time"};
  fields.Word("rule", event.rule, kRules);
  fields.Text("vehicle", event.vehicle, {});
  ResolveVehicle(fields, "vehicle", event.vehicle, mission, false);
  fields.Require("value", "value = 250");
  fields.NumberOrWord("value", event.value, kLongest_s, "nolimit", -1);
}

}  // namespace

void Describe(Fields& fields, Event& event, const Mission& mission) {
  fields.Require("at_s", "at_s = 60");
  fields.Number("at_s", event.at_s,
                Between(0, mission.duration_s > 0 ? mission.duration_s : kLongest_s));
  const bool command = fields.Has("command", std::holds_alternative<CommandEvent>(event.what));
  const bool sim = fields.Has("sim_command", std::holds_alternative<SimCommandEvent>(event.what));
  const bool rule = fields.Has("rule", std::holds_alternative<RuleEvent>(event.what));
  if (command + sim + rule != 1) {
    fields.Refuse("", "an event needs one of command, sim_command and rule, and only one");
    fields.SkipRest();
    return;
  }
  if (fields.reading()) {
    if (sim) event.what = SimCommandEvent();
    if (rule) event.what = RuleEvent();
  }
  std::visit([&](auto& what) { Describe(fields, what, mission); }, event.what);
}

}  // namespace shoal
