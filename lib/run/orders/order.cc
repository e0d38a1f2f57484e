#include "lib/run/orders/order.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "lib/base/text/letters.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/model/names.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/orders/order_words.h"
#include "lib/run/run/roster.h"

namespace shoal {

namespace {

constexpr std::string_view kClock = "clock";

/// Returns what a target that is neither vehicle nor rule was meant to be.
std::string UnknownTarget(const OrderScope& scope, std::string_view target) {
  std::vector<std::string_view> rules;
  for (const ControlRow& row : ControlTable()) rules.push_back(row.rule);
  std::vector<std::string_view> known(scope.vehicles.begin(), scope.vehicles.end());
  known.insert(known.end(), rules.begin(), rules.end());
  known.push_back(kClock);
  std::vector<std::string_view> orders;
  for (const OrderWords& order : scope.orders) {
    if (std::find(orders.begin(), orders.end(), order.name) == orders.end()) {
      orders.push_back(order.name);
    }
  }
  known.insert(known.end(), orders.begin(), orders.end());
  const std::string word = std::string(target.substr(0, 64));
  return fmt::format(
      "no vehicle {} in {}{}; it has: {}; other targets: all, group:NAME, clock, {}and the rules "
      "{}",
      Quoted(word), scope.mission, DidYouMean(word, known), fmt::join(scope.vehicles, ", "),
      orders.empty() ? "" : fmt::format("the orders {}, ", Joined(orders)), Joined(rules));
}

std::string UnknownGroup(const OrderScope& scope, std::string_view group) {
  if (scope.groups.empty()) {
    return fmt::format("no group {} in {}: none of its vehicles has one",
                       Quoted(std::string(group.substr(0, 64))), scope.mission);
  }
  std::vector<std::string_view> groups;
  for (const auto& [name, members] : scope.groups) groups.push_back(name);
  const std::string word = std::string(group.substr(0, 64));
  return fmt::format("no group {} in {}{}; it has: {}", Quoted(word), scope.mission,
                     DidYouMean(word, groups), Joined(groups));
}

/// Returns the vehicles that a target means: one, a group's, or all; none where it means another.
std::vector<std::string> VehiclesOf(const OrderScope& scope, std::string_view target) {
  std::vector<std::string> vehicles;
  if (const std::optional<std::string_view> group = GroupNamed(target)) {
    for (const auto& [name, members] : scope.groups) {
      if (LowerCase(name) == LowerCase(*group)) vehicles = members;
    }
    return vehicles;
  }
  for (const std::string& name : scope.vehicles) {
    if (target == "all" || VehicleKey(name) == VehicleKey(target)) vehicles.push_back(name);
  }
  return vehicles;
}

template <class T, class Command, class Make>
Result<Order> OrderOr(const Result<Command>& parsed, Make make) {
  if (!parsed.ok()) return Error{parsed.error()};
  return Order(T(make(*parsed)));
}

/// An order of each kind, distinguished by the first words of the events that report it;
/// apps/helm/helm_app.cc, apps/vehicle_sim/vehicle_sim_app.cc, apps/shore_broker/apply_control.cc.
OrderTrace HelmTrace(const std::string& vehicle, const helm_command_t& command) {
  return {.app = ParticipantName("helm", vehicle),
          .participant = vehicle,
          .taken = "command: " + command.command,
          .refused = "HELM_COMMAND refused: " + command.command};
}

OrderTrace SimTrace(const std::string& vehicle, const sim_command_t& command) {
  return {.app = ParticipantName("vehicle_sim", vehicle),
          .participant = vehicle,
          .taken = command.command + " ",
          .refused = fmt::format("SIM_COMMAND refused: '{}'", command.command)};
}

OrderTrace BrokerTrace(const ControlRow& row) {
  return {.app = "shore_broker",
          .participant = "shore_broker",
          .taken = fmt::format("{}: ", row.channel),
          .refused = fmt::format("{} refused: ", row.channel)};
}

bool HasOrder(const OrderScope& scope, std::string_view name) {
  return std::any_of(scope.orders.begin(), scope.orders.end(),
                     [&](const OrderWords& each) { return each.name == name; });
}

Result<Order> ParseOrderByName(const OrderScope& scope, std::string_view name,
                               std::span<const std::string> words) {
  if (!words.empty()) {
    return Error{
        fmt::format("{} is an [[order]] of {}: it takes no more words", name, scope.mission)};
  }
  OrderByName named;
  for (const OrderWords& each : scope.orders) {
    if (each.name != name) continue;
    const Result<helm_command_t> command = ParseHelmWords(each.words);
    if (!command.ok()) return Error{fmt::format("order {}: {}", name, command.error())};
    const std::vector<std::string> vehicles = VehiclesOf(scope, each.target);
    if (vehicles.empty()) return Error{UnknownTarget(scope, each.target)};
    named.orders.push_back({.vehicles = vehicles, .command = *command});
  }
  return Order(std::move(named));
}

}  // namespace

bool HasVehicle(const OrderScope& scope, std::string_view name) {
  const std::string key = VehicleKey(name);
  return std::any_of(scope.vehicles.begin(), scope.vehicles.end(),
                     [&](const std::string& each) { return VehicleKey(each) == key; });
}

Result<Order> ParseOrder(const OrderScope& scope, std::string_view target,
                         std::span<const std::string> words) {
  if (scope.is_playback && target != kClock) {
    return Error{
        fmt::format("{}: a recording takes no orders; `clock` alone can be the target: "
                    "pause, resume, warp N, seek SECONDS",
                    scope.mission)};
  }
  const std::vector<std::string> vehicles = VehiclesOf(scope, target);
  if (vehicles.empty()) {
    if (const auto group = GroupNamed(target)) return Error{UnknownGroup(scope, *group)};
    if (const ControlRow* row = FindControl(target); row != nullptr) {
      return OrderOr<OrderToBroker>(ParseRuleWords(*row, words), [&](const unc_control_t& control) {
        return OrderToBroker{
            .row = row,
            .control = control,
            .is_unregistered = row->of_vehicle && !HasVehicle(scope, control.vehicle)};
      });
    }
    if (target == kClock) {
      return OrderOr<OrderToClock>(ParseClockWords(words), [](const clock_command_t& command) {
        return OrderToClock{.command = command};
      });
    }
    if (HasOrder(scope, target)) return ParseOrderByName(scope, target, words);
    return Error{UnknownTarget(scope, target)};
  }
  if (words.empty()) return Error{"a command is missing: " + SendCommandsText()};
  if (words[0] == "sim") {
    return OrderOr<OrderToSims>(ParseSimWords(words.subspan(1)), [&](const sim_command_t& command) {
      return OrderToSims{.vehicles = vehicles, .command = command};
    });
  }
  if (words[0] == "message") {
    return OrderOr<MessageOfVehicles>(ParseMessageWords(words), [&](const node_message_t& message) {
      return MessageOfVehicles{.vehicles = vehicles, .message = message};
    });
  }
  return OrderOr<OrderToHelms>(ParseHelmWords(words), [&](const helm_command_t& command) {
    return OrderToHelms{.vehicles = vehicles, .command = command};
  });
}

namespace {

struct Publisher {
  Bus& bus;

  void operator()(const OrderToHelms& order) const {
    for (const std::string& vehicle : order.vehicles) {
      Publish(bus, channels::HelmCommand(vehicle), order.command);
    }
  }
  void operator()(const OrderToSims& order) const {
    for (const std::string& vehicle : order.vehicles) {
      Publish(bus, channels::SimCommand(vehicle), order.command);
    }
  }
  void operator()(const MessageOfVehicles& order) const {
    node_message_t message = order.message;
    message.src_app = "shoal_send";
    for (const std::string& vehicle : order.vehicles) {
      message.src_node = vehicle;
      // Its node_reporter gives an acknowledged message its ack_id, and repeats it.
      Publish(bus,
              message.ack_requested != 0 ? channels::MediatedMessage(vehicle)
                                         : channels::NodeMessageLocal(),
              message);
    }
  }
  void operator()(const OrderToBroker& order) const {
    Publish(bus, channels::Control(*order.row), order.control);
  }
  void operator()(const OrderByName& named) const {
    for (const OrderToHelms& order : named.orders) (*this)(order);
  }
  void operator()(const OrderToClock& order) const {
    Publish(bus, channels::ClockCommand(), order.command);
  }
};

}  // namespace

void Publish(Bus& bus, const Order& order) { std::visit(Publisher{bus}, order); }

std::vector<OrderTrace> TracesOf(const Order& order) {
  std::vector<OrderTrace> traces;
  if (const auto* helms = std::get_if<OrderToHelms>(&order)) {
    for (const std::string& each : helms->vehicles) {
      traces.push_back(HelmTrace(each, helms->command));
    }
  } else if (const auto* sims = std::get_if<OrderToSims>(&order)) {
    for (const std::string& each : sims->vehicles) traces.push_back(SimTrace(each, sims->command));
  } else if (const auto* named = std::get_if<OrderByName>(&order)) {
    for (const OrderToHelms& each : named->orders) {
      for (OrderTrace& trace : TracesOf(each)) traces.push_back(std::move(trace));
    }
  } else if (const auto* broker = std::get_if<OrderToBroker>(&order)) {
    traces.push_back(BrokerTrace(*broker->row));
  }
  return traces;
}

}  // namespace shoal
