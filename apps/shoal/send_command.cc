#include "apps/shoal/send_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "apps/shoal/send_helm.h"
#include "apps/shoal/send_words.h"
#include "lib/bus/channels.h"
#include "lib/bus/lcm_bus.h"
#include "lib/check/result.h"
#include "lib/mission/suggest.h"
#include "lib/routing/destinations.h"
#include "lib/routing/vehicle_name.h"
#include "lib/run/roster.h"
#include "lib/run/run_registry.h"

namespace shoal {

namespace {

int Usage(const std::string& why) {
  fmt::print(stderr, "shoal: {}\n", why);
  return kExitUsage;
}

int SendRule(LcmBus& bus, const RunningMission& mission, const ControlRow& row,
             const SendOptions& options) {
  const Result<unc_control_t> control = ParseRuleWords(row, options.words);
  if (!control.ok()) return Usage(control.error());
  Publish(bus, channels::Control(row), *control);
  if (!BusWorks(bus)) return kExitEnvironment;
  const std::string of = row.of_vehicle ? " of " + control->vehicle : "";
  const std::string value =
      row.type == ControlType::kRequest ? "" : " = " + ControlWord(row, control->value);
  const bool is_known = std::any_of(
      mission.vehicles.begin(), mission.vehicles.end(),
      [&](const std::string& name) { return VehicleKey(name) == VehicleKey(control->vehicle); });
  fmt::print("sent {}{}{}; `shoal status shore_broker` shows the rules in force\n", row.channel, of,
             value);
  if (row.of_vehicle && !is_known) {
    fmt::print("{} is no vehicle of {}: it must come from outside\n", control->vehicle,
               mission.name);
  }
  return kExitOk;
}

/// Says which of the addressees are not of the mission: a slip, or vehicles from outside.
void TellOfStrangers(const RunningMission& mission, const node_message_t& message) {
  for (const std::string& name : ParseDestinations(message.dest_node).names) {
    const bool is_known =
        std::any_of(mission.vehicles.begin(), mission.vehicles.end(),
                    [&](const std::string& each) { return VehicleKey(each) == VehicleKey(name); });
    if (!is_known) {
      fmt::print("{} is no vehicle of {}: it must come from outside\n", name, mission.name);
    }
  }
}

int SendMessages(LcmBus& bus, const RunningMission& mission,
                 const std::vector<std::string>& vehicles, std::span<const std::string> words) {
  const Result<node_message_t> parsed = ParseMessageWords(words);
  if (!parsed.ok()) return Usage(parsed.error());
  node_message_t message = *parsed;
  message.src_app = "shoal_send";
  const bool wants_ack = message.ack_requested != 0;
  for (const std::string& vehicle : vehicles) {
    message.src_node = vehicle;
    // Its node_reporter gives an acknowledged message its ack_id, and repeats it.
    Publish(bus, wants_ack ? channels::MediatedMessage(vehicle) : channels::NodeMessageLocal(),
            message);
  }
  if (!BusWorks(bus)) return kExitEnvironment;
  fmt::print("sent {} of {} to {}\n`shoal status shore_broker` shows what became of it\n",
             message.var_name, fmt::join(vehicles, ", "),
             message.dest_group.empty() ? message.dest_node : "group " + message.dest_group);
  TellOfStrangers(mission, message);
  if (wants_ack) {
    fmt::print("`shoal status {}` shows whether it was acknowledged\n",
               ParticipantName("node_reporter", vehicles.front()));
  }
  return kExitOk;
}

int SendSim(LcmBus& bus, const std::vector<std::string>& vehicles,
            std::span<const std::string> words) {
  const Result<sim_command_t> command = ParseSimWords(words.subspan(1));
  if (!command.ok()) return Usage(command.error());
  for (const std::string& vehicle : vehicles) {
    Publish(bus, channels::SimCommand(vehicle), *command);
  }
  if (!BusWorks(bus)) return kExitEnvironment;
  fmt::print("sent sim {} to {}\n", command->command, fmt::join(vehicles, ", "));
  return kExitOk;
}

/// Returns what a target that is neither vehicle nor rule was meant to be.
std::string UnknownTarget(const RunningMission& mission, const std::string& target) {
  std::vector<std::string_view> rules;
  for (const ControlRow& row : ControlTable()) rules.push_back(row.rule);
  std::vector<std::string_view> known(mission.vehicles.begin(), mission.vehicles.end());
  known.insert(known.end(), rules.begin(), rules.end());
  return fmt::format("no vehicle {} in {}{}; it has: {}; or say all, or one of the rules {}",
                     Quoted(target), mission.name, DidYouMean(target, known),
                     fmt::join(mission.vehicles, ", "), Joined(rules));
}

}  // namespace

int RunSend(const SendOptions& options) {
  const Result<RunningMission> mission = FindRunningMission(options.port_base);
  if (!mission.ok()) {
    fmt::print(stderr, "shoal: {}\n", mission.error());
    return kExitEnvironment;
  }
  std::vector<std::string> vehicles;
  for (const std::string& name : mission->vehicles) {
    if (options.target == "all" || VehicleKey(name) == VehicleKey(options.target)) {
      vehicles.push_back(name);
    }
  }
  LcmBus bus(mission->Ports());
  if (vehicles.empty()) {
    const ControlRow* rule = FindControl(options.target);
    if (rule != nullptr) return SendRule(bus, *mission, *rule, options);
    return Usage(UnknownTarget(*mission, options.target));
  }
  const std::span<const std::string> words(options.words);
  if (words.empty()) return Usage("say what: " + SendCommandsText());
  if (words[0] == "sim") return SendSim(bus, vehicles, words);
  if (words[0] == "message") return SendMessages(bus, *mission, vehicles, words);
  const Result<helm_command_t> command = ParseHelmWords(words);
  if (!command.ok()) return Usage(command.error());
  return SendHelm(bus, vehicles, *command);
}

}  // namespace shoal
