#include "lib/run/orders/order_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "lib/base/text/numbers.h"
#include "lib/bus/bus/control_message.h"
#include "lib/comms/routing/destinations.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/model/names.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

constexpr std::string_view kMessageUsage =
    "usage: message DEST VAR VALUE [--double] [--ack]; DEST: names joined by ':', all, or "
    "group:NAME";

/// Of CommandShape::num_values: two for each of one or more points.
constexpr int kPoints = -1;

/// One command's shape.
struct CommandShape {
  std::string_view name;
  bool takes_text = false;            ///< One word, such as a task's name.
  std::vector<int> num_values = {0};  ///< Allowed counts of numbers.
  std::string_view help;
};

const std::vector<CommandShape>& HelmCommands() {
  static const std::vector<CommandShape> shapes = {
      {"deploy", false, {0}, "start the list of tasks, or go on with it"},
      {"return", false, {0}, "go home and stay there"},
      {"station_keep", false, {0}, "stay here"},
      {"all_stop", false, {0}, "stop the actuators"},
      {"resume", false, {0}, "go on after all_stop"},
      {"park", false, {0}, "end all tasks"},
      {"goto", false, {2}, "X Y: go to a point (metres East, North) and stay there"},
      {"speed", false, {1}, "V: go at V m/s until the next task"},
      {"task", true, {0}, "NAME: jump to a task"},
      {"move", true, {kPoints}, "NAME X Y [X Y ...]: another place for a task"},
      {"set", true, {0}, "VARIABLE=VALUE: set a variable of the behaviors"},
  };
  return shapes;
}

const std::vector<CommandShape>& SimCommands() {
  static const std::vector<CommandShape> shapes = {
      {"pause", false, {0}, "hold the vehicle where it is"},
      {"resume", false, {0}, "let it move again"},
      {"reset", false, {0, 4, 5}, "[X Y HEADING SPEED [DEPTH]]: back to the start, or to a pose"},
      {"drift", false, {2}, "X Y: add a drift of X m/s East, Y m/s North"},
  };
  return shapes;
}

const std::vector<CommandShape>& ClockCommands() {
  static const std::vector<CommandShape> shapes = {
      {"pause", false, {0}, "hold the whole mission"},
      {"resume", false, {0}, "let it go on"},
      {"warp", true, {0}, "N: N mission seconds per wall second; max: as fast as possible"},
      {"seek", true, {0}, "S: of `shoal play`: go on S seconds behind the log's begin"},
  };
  return shapes;
}

std::string Rows(std::string_view prefix, std::span<const CommandShape> shapes) {
  std::string text;
  for (const CommandShape& shape : shapes) {
    text += fmt::format("  {:<28} {}\n", fmt::format("{}{}", prefix, shape.name), shape.help);
  }
  return text;
}

/// What is in a helm command's place, but is for others.
const std::vector<CommandShape>& OtherCommands() {
  static const std::vector<CommandShape> shapes = {
      {"sim", true, {0}, "COMMAND: an order to the simulator"},
      {"message", true, {0}, "DEST VAR VALUE: a node message of the vehicle"},
  };
  return shapes;
}

std::string UnknownCommand(const std::string& name, std::span<const CommandShape> shapes) {
  std::vector<std::string_view> names;
  for (const CommandShape& shape : shapes) names.push_back(shape.name);
  return fmt::format("unknown command {}{}; there are:\n{}", Quoted(name), DidYouMean(name, names),
                     Rows("", shapes));
}

/// Words after the command, as the command wants them.
struct Arguments {
  std::string text;
  std::vector<double> values;
};

Result<Arguments> ParseArguments(const std::vector<CommandShape>& shapes, const std::string& name,
                                 std::span<const std::string> words) {
  const auto shape = std::find_if(shapes.begin(), shapes.end(),
                                  [&](const CommandShape& each) { return each.name == name; });
  if (shape == shapes.end()) return Error{UnknownCommand(name, shapes)};
  Arguments arguments;
  if (shape->takes_text) {
    const bool takes_points = shape->num_values.front() == kPoints;
    const bool is_right =
        takes_points ? words.size() >= 3 && words.size() % 2 == 1 : words.size() == 1;
    if (!is_right) return Error{fmt::format("usage: {} {}", shape->name, shape->help)};
    arguments.text = words.front();
    if (!takes_points) return arguments;
    words = words.subspan(1);
  }
  for (const std::string& word : words) {
    const std::optional<double> value = ReadNumber<double>(word);
    if (!value) return Error{fmt::format("'{}' is not a number", word)};
    arguments.values.push_back(*value);
  }
  if (shape->takes_text) return arguments;
  if (std::find(shape->num_values.begin(), shape->num_values.end(),
                static_cast<int>(words.size())) == shape->num_values.end()) {
    return Error{fmt::format("usage: {} {}", shape->name, shape->help)};
  }
  return arguments;
}

/// How to write a rule: "stealth VEHICLE 0.5 (0 to 1)".
std::string RuleUsage(const ControlRow& row) {
  std::string usage(row.rule);
  if (row.of_vehicle) usage += " VEHICLE";
  if (row.type != ControlType::kRequest) usage += fmt::format(" {}", row.example);
  return fmt::format("usage: shoal send {} ({})", usage, row.values);
}

}  // namespace

Result<helm_command_t> ParseHelmWords(std::span<const std::string> words) {
  std::vector<CommandShape> all = HelmCommands();
  const bool is_known = std::any_of(
      all.begin(), all.end(), [&](const CommandShape& shape) { return shape.name == words[0]; });
  if (!is_known) {
    all.insert(all.end(), OtherCommands().begin(), OtherCommands().end());
    return Error{UnknownCommand(words[0], all)};
  }
  Result<Arguments> arguments = ParseArguments(HelmCommands(), words[0], words.subspan(1));
  if (!arguments.ok()) return Error{arguments.error()};
  helm_command_t command{};
  command.command = words[0];
  command.argument = arguments->text;
  command.values = arguments->values;
  command.num_values = static_cast<int32_t>(command.values.size());
  return command;
}

Result<sim_command_t> ParseSimWords(std::span<const std::string> words) {
  if (words.empty()) return Error{"a command is missing:\n" + Rows("sim ", SimCommands())};
  Result<Arguments> arguments = ParseArguments(SimCommands(), words[0], words.subspan(1));
  if (!arguments.ok()) return Error{arguments.error()};
  sim_command_t command{};
  command.command = words[0];
  command.values = arguments->values;
  command.num_values = static_cast<int32_t>(command.values.size());
  return command;
}

Result<unc_control_t> ParseRuleWords(const ControlRow& row, std::span<const std::string> words) {
  const bool takes_value = row.type != ControlType::kRequest;
  const size_t num_words = (row.of_vehicle ? 1 : 0) + (takes_value ? 1 : 0);
  if (words.size() != num_words) return Error{RuleUsage(row)};
  unc_control_t control{};
  if (row.of_vehicle) {
    control.vehicle = words.front();
    if (!IsLegalVehicleName(control.vehicle)) {
      return Error{
          fmt::format("{} is not a vehicle's name; {}", Quoted(words.front()), RuleUsage(row))};
    }
  }
  if (!takes_value) return control;
  const std::optional<ControlValue> value = ParseControlValue(row, words.back());
  if (!value) {
    return Error{
        fmt::format("{} is not a value of {}; {}", Quoted(words.back()), row.rule, RuleUsage(row))};
  }
  SetValue(*value, &control);
  return control;
}

Result<clock_command_t> ParseClockWords(std::span<const std::string> words) {
  if (words.empty()) return Error{"a command is missing:\n" + Rows("clock ", ClockCommands())};
  Result<Arguments> arguments = ParseArguments(ClockCommands(), words[0], words.subspan(1));
  if (!arguments.ok()) return Error{arguments.error()};
  clock_command_t command{};
  command.command = words[0];
  if (words[0] == "seek") {
    const std::optional<double> to_s = ReadNumber<double>(arguments->text);
    if (!to_s || !(*to_s >= 0)) {
      return Error{fmt::format("{} is not a time: give seconds since the log's begin",
                               Quoted(arguments->text))};
    }
    command.command = fmt::format("seek {}", *to_s);
    return command;
  }
  if (words[0] != "warp") return command;
  const std::optional<double> warp = ParseWarp(arguments->text);
  if (!warp) {
    return Error{
        fmt::format("{} is not a warp: give a number from 1e-6 to 1e6, or max: as fast as possible",
                    Quoted(arguments->text))};
  }
  command.warp = *warp;
  return command;
}

std::optional<double> ParseWarp(std::string_view word) {
  constexpr double kHighest = 1e6;
  if (word == "max") return 0;
  const std::optional<double> warp = ReadNumber<double>(word);
  if (!warp || *warp < 1 / kHighest || *warp > kHighest) return std::nullopt;
  return warp;
}

Result<node_message_t> ParseMessageWords(std::span<const std::string> words) {
  node_message_t message{};
  std::vector<std::string> plain;
  for (const std::string& word : words.subspan(1)) {
    if (word == "--double") {
      message.is_double = 1;
    } else if (word == "--ack") {
      message.ack_requested = 1;
    } else {
      plain.push_back(word);
    }
  }
  if (plain.size() != 3 || plain[1].empty()) return Error{std::string(kMessageUsage)};
  if (const auto group = GroupNamed(plain[0])) {
    message.dest_group = *group;
  } else {
    message.dest_node = plain[0];
  }
  const Destinations nodes = ParseDestinations(message.dest_node);
  if (message.dest_group.empty() && nodes.names.empty() && !nodes.all) {
    return Error{"no vehicle to send it to; " + std::string(kMessageUsage)};
  }
  message.var_name = plain[1];
  if (message.is_double == 0) {
    message.string_val = plain[2];
    return message;
  }
  const std::optional<double> value = ReadNumber<double>(plain[2]);
  if (!value) return Error{fmt::format("{} is not a number", Quoted(plain[2]))};
  message.double_val = *value;
  return message;
}

std::string SendCommandsText() {
  std::string text =
      "VEHICLE is a vehicle's name, group:NAME (its members) or all.\n" +
      Rows("VEHICLE ", HelmCommands()) + Rows("VEHICLE sim ", SimCommands()) +
      "  VEHICLE message DEST VAR VALUE [--double] [--ack]\n"
      "                               a node message of VEHICLE. DEST: names joined "
      "by ':', all, or group:NAME;\n"
      "                               --double: VALUE is a number; --ack: sent again "
      "until it is acknowledged\n"
      "The broker's rules:\n";
  for (const ControlRow& row : ControlTable()) {
    std::string name(row.rule);
    if (row.of_vehicle) name += " NAME";
    if (row.type == ControlType::kRequest) {
      text += fmt::format("  {:<28} NAME receives the next report of each other vehicle\n", name);
    } else {
      text += fmt::format("  {:<28} {}\n", name + " VALUE", row.values);
    }
  }
  return text + "The mission's clock:\n" + Rows("clock ", ClockCommands());
}

}  // namespace shoal
