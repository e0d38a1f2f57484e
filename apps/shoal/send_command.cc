#include "apps/shoal/send_command.h"

#include <fmt/format.h>

#include <variant>

#include "apps/shoal/send_clock.h"
#include "apps/shoal/send_helm.h"
#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/control_message.h"
#include "lib/comms/routing/destinations.h"
#include "lib/run/orders/order.h"
#include "lib/run/run/roster.h"
#include "lib/run/run/run_registry.h"

namespace shoal {

namespace {

void WarnOfUnregistered(const OrderScope& scope, const std::string& name) {
  fmt::print("{} is not a vehicle of {}: it must be an unregistered vehicle\n", name,
             scope.mission);
}

/// Sends an order of each kind, and returns the exit code.
struct Sender {
  LcmBus& bus;
  const OrderScope& scope;
  const Order& whole;
  const std::vector<std::string>& without_helm;

  int operator()(const OrderToHelms& order) const {
    return SendHelm(bus, {.orders = {order}}, without_helm);
  }
  int operator()(const OrderByName& named) const { return SendHelm(bus, named, without_helm); }
  int operator()(const OrderToClock& order) const { return SendClock(bus, order); }

  int operator()(const OrderToSims& order) const {
    Publish(bus, whole);
    if (!BusWorks(bus)) return kExitEnvironment;
    fmt::print("sent sim {} to {}\n", order.command.command, fmt::join(order.vehicles, ", "));
    return kExitOk;
  }

  int operator()(const OrderToBroker& order) const {
    Publish(bus, whole);
    if (!BusWorks(bus)) return kExitEnvironment;
    const ControlRow& row = *order.row;
    const std::string of = row.of_vehicle ? " of " + order.control.vehicle : "";
    const std::string value =
        row.type == ControlType::kRequest ? "" : " = " + ControlWord(row, ValueOf(order.control));
    fmt::print("sent {}{}{}; `shoal status shore_broker` shows the rules in force\n", row.channel,
               of, value);
    if (order.is_unregistered) WarnOfUnregistered(scope, order.control.vehicle);
    return kExitOk;
  }

  int operator()(const MessageOfVehicles& order) const {
    Publish(bus, whole);
    if (!BusWorks(bus)) return kExitEnvironment;
    const node_message_t& message = order.message;
    fmt::print("sent {} of {} to {}\n`shoal status shore_broker` shows what became of it\n",
               message.var_name, fmt::join(order.vehicles, ", "),
               message.dest_group.empty() ? message.dest_node : "group " + message.dest_group);
    for (const std::string& name : ParseDestinations(message.dest_node).names) {
      if (!HasVehicle(scope, name)) WarnOfUnregistered(scope, name);
    }
    if (message.ack_requested != 0) {
      fmt::print("`shoal status {}` shows whether it was acknowledged\n",
                 ParticipantName("node_reporter", order.vehicles.front()));
    }
    return kExitOk;
  }
};

}  // namespace

bool BusWorks(const LcmBus& bus) {
  if (!bus.error().empty()) fmt::print(stderr, "shoal: {}\n", bus.error());
  return bus.error().empty();
}

int RunSend(const SendOptions& options) {
  const Result<RunningMission> mission = FindRunningMission(options.port_base, Purpose::kCommand);
  if (!mission.ok()) {
    fmt::print(stderr, "shoal: {}\n", mission.error());
    return kExitEnvironment;
  }
  const OrderScope scope = {.mission = mission->name,
                            .vehicles = mission->vehicles,
                            .groups = mission->groups,
                            .is_playback = !mission->playback_of.empty(),
                            .orders = mission->orders};
  const Result<Order> order = ParseOrder(scope, options.target, options.words);
  if (!order.ok()) {
    fmt::print(stderr, "shoal: {}\n", order.error());
    return kExitUsage;
  }
  fmt::print("{}\n", Describe(*mission));
  std::fflush(stdout);
  LcmBus bus(mission->Ports());
  return std::visit(Sender{bus, scope, *order, mission->without_helm}, *order);
}

}  // namespace shoal
