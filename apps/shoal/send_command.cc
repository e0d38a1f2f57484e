#include "apps/shoal/send_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>

#include "apps/shoal/status_command.h"
#include "lib/bus/channels.h"
#include "lib/bus/lcm_bus.h"
#include "lib/check/result.h"
#include "lib/run/run_app.h"
#include "lib/run/run_registry.h"

namespace shoal {

namespace {

/// How long an answer from the helm is waited for: a step, and the second of its own rhythm.
constexpr int64_t kAnswerPatience_us = 1'500'000;

/// An order takes effect in the next step; at real time that is some tenths of a second.
constexpr int64_t kObeyTime_us = 300'000;

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
  };
  return shapes;
}

const std::vector<CommandShape>& SimCommands() {
  static const std::vector<CommandShape> shapes = {
      {"pause", false, {0}, "hold the vehicle where it is"},
      {"resume", false, {0}, "let it move again"},
      {"reset", false, {0, 4}, "[X Y HEADING SPEED]: back to the start, or to a pose"},
      {"drift", false, {2}, "X Y: add a drift of X m/s East, Y m/s North"},
  };
  return shapes;
}

std::string Rows(std::string_view prefix, const std::vector<CommandShape>& shapes) {
  std::string text;
  for (const CommandShape& shape : shapes) {
    text += fmt::format("  {:<28} {}\n", fmt::format("{}{}", prefix, shape.name), shape.help);
  }
  return text;
}

std::optional<double> ParseNumber(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
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
  if (shape == shapes.end()) {
    return Error{fmt::format("unknown command '{}'; there are:\n{}", name, Rows("", shapes))};
  }
  Arguments arguments;
  if (shape->takes_text) {
    if (words.size() != 1) {
      return Error{fmt::format("usage: {} {}", shape->name, shape->help)};
    }
    arguments.text = words.front();
    return arguments;
  }
  for (const std::string& word : words) {
    const std::optional<double> value = ParseNumber(word);
    if (!value) return Error{fmt::format("'{}' is not a number", word)};
    arguments.values.push_back(*value);
  }
  if (std::find(shape->num_values.begin(), shape->num_values.end(),
                static_cast<int>(words.size())) == shape->num_values.end()) {
    return Error{fmt::format("usage: {} {}", shape->name, shape->help)};
  }
  return arguments;
}

std::optional<Channel<unc_control_t>> RuleChannel(const std::string& rule) {
  if (rule == "comms_range") return channels::UncCommsRange();
  if (rule == "stale_time") return channels::UncStaleTime();
  return std::nullopt;
}

/// Returns what the helms have refused so far, by the participant's name.
std::map<std::string, std::set<std::string>> Refusals(const PortPlan& ports) {
  constexpr std::string_view kPrefix = "HELM_COMMAND refused: ";
  std::map<std::string, std::set<std::string>> refusals;
  const auto pages = CollectPages(ports, "all");
  if (!pages.ok()) return refusals;
  for (const auto& [name, page] : *pages) {
    for (const std::string& warning : page.run_warnings) {
      if (warning.starts_with(kPrefix)) refusals[name].insert(warning.substr(kPrefix.size()));
    }
  }
  return refusals;
}

int BusError(const LcmBus& bus) {
  fmt::print(stderr, "shoal: {}\n", bus.error());
  return kExitEnvironment;
}

int SendRule(LcmBus& bus, const Channel<unc_control_t>& channel, const SendOptions& options) {
  std::optional<double> value;
  if (options.words.size() == 1) value = ParseNumber(options.words.front());
  if (options.words == std::vector<std::string>{"nolimit"} && options.target == "comms_range") {
    value = -1;
  }
  if (!value) {
    fmt::print(stderr, "shoal: usage: shoal send {} NUMBER\n", options.target);
    return kExitUsage;
  }
  unc_control_t control{};
  control.value = *value;
  Publish(bus, channel, control);
  if (!bus.error().empty()) return BusError(bus);
  fmt::print("sent {} = {}; `shoal status shore_broker` shows the rules in force\n", channel.name,
             *value);
  return kExitOk;
}

/// Publishes to each vehicle and shows what its helm says next.
int SendHelm(LcmBus& bus, const PortPlan& ports, const std::vector<std::string>& vehicles,
             const std::string& command, const Arguments& arguments) {
  const auto refused_before = Refusals(ports);
  std::set<std::string> answered;
  bool sent = false;
  for (const std::string& vehicle : vehicles) {
    Subscribe(bus, channels::HelmState(vehicle), [&, vehicle](const helm_state_t& state) {
      if (!sent || !answered.insert(vehicle).second) return;
      fmt::print("{}: {} {} ({})\n", vehicle, state.state, state.task, state.all_stop);
    });
  }
  bus.Poll(0);
  for (const std::string& vehicle : vehicles) {
    helm_command_t message{};
    message.command = command;
    message.argument = arguments.text;
    message.values = arguments.values;
    message.num_values = static_cast<int32_t>(arguments.values.size());
    Publish(bus, channels::HelmCommand(vehicle), message);
  }
  if (!bus.error().empty()) return BusError(bus);
  fmt::print("sent {} to {}\n", command, fmt::join(vehicles, ", "));
  sent = true;
  const int64_t begin = MonotonicMicroseconds();
  while (MonotonicMicroseconds() - begin < kObeyTime_us) bus.Poll(20'000);
  while (answered.size() < vehicles.size() &&
         MonotonicMicroseconds() - begin < kAnswerPatience_us) {
    bus.Poll(20'000);
  }
  if (answered.size() < vehicles.size()) {
    fmt::print("{} of {} helms have said nothing since; `shoal status` shows who is there\n",
               vehicles.size() - answered.size(), vehicles.size());
  }
  bool refused = false;
  for (const auto& [name, reasons] : Refusals(ports)) {
    const auto before = refused_before.find(name);
    for (const std::string& reason : reasons) {
      if (before != refused_before.end() && before->second.contains(reason)) continue;
      fmt::print(stderr, "{} refused: {}\n", name, reason);
      refused = true;
    }
  }
  return refused ? kExitUsage : kExitOk;
}

}  // namespace

std::string SendCommandsText() {
  return "VEHICLE is a vehicle's name or all.\n" + Rows("VEHICLE ", HelmCommands()) +
         Rows("VEHICLE sim ", SimCommands()) +
         fmt::format("  {:<28} {}\n  {:<28} {}\n", "comms_range R",
                     "the broker's rule, metres; or nolimit", "stale_time T",
                     "the broker's rule, seconds");
}

int RunSend(const SendOptions& options) {
  const auto usage = [](const std::string& why) {
    fmt::print(stderr, "shoal: {}\n", why);
    return static_cast<int>(kExitUsage);
  };
  const Result<RunningMission> mission = FindRunningMission(options.port_base);
  if (!mission.ok()) {
    fmt::print(stderr, "shoal: {}\n", mission.error());
    return kExitEnvironment;
  }
  std::vector<std::string> vehicles;
  for (const std::string& name : mission->vehicles) {
    if (options.target == "all" || UpperCase(name) == UpperCase(options.target)) {
      vehicles.push_back(name);
    }
  }
  LcmBus bus(mission->Ports());
  if (vehicles.empty()) {
    if (const auto rule = RuleChannel(options.target)) {
      return SendRule(bus, *rule, options);
    }
    return usage(
        fmt::format("no vehicle '{}' in {}; it has: {}; or say all, or one of the rules "
                    "comms_range, stale_time",
                    options.target, mission->name, fmt::join(mission->vehicles, ", ")));
  }
  if (options.words.empty()) return usage("say what: " + SendCommandsText());
  const std::span<const std::string> words(options.words);
  if (words[0] != "sim") {
    const auto arguments = ParseArguments(HelmCommands(), words[0], words.subspan(1));
    if (!arguments.ok()) return usage(arguments.error());
    return SendHelm(bus, mission->Ports(), vehicles, words[0], *arguments);
  }
  if (words.size() < 2) return usage("say what:\n" + Rows("sim ", SimCommands()));
  const auto arguments = ParseArguments(SimCommands(), words[1], words.subspan(2));
  if (!arguments.ok()) return usage(arguments.error());
  for (const std::string& vehicle : vehicles) {
    sim_command_t message{};
    message.command = words[1];
    message.values = arguments->values;
    message.num_values = static_cast<int32_t>(arguments->values.size());
    Publish(bus, channels::SimCommand(vehicle), message);
  }
  if (!bus.error().empty()) return BusError(bus);
  fmt::print("sent sim {} to {}\n", words[1], fmt::join(vehicles, ", "));
  return kExitOk;
}

}  // namespace shoal
