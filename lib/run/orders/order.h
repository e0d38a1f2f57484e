// An order: a target and words as `shoal send` takes them, parsed.
//
//   const Result<Order> order = ParseOrder({.mission = "berta", .vehicles = {"alpha"}}, "alpha",
//                                          {"goto", "10", "-20"});
//   if (order.ok()) Publish(bus, *order);
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/bus.h"
#include "lib/comms/routing/control.h"
#include "lib/mission/model/mission.h"
#include "lib/run/orders/order_watch.h"
#include "shoal/clock_command_t.hpp"
#include "shoal/helm_command_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/sim_command_t.hpp"
#include "shoal/unc_control_t.hpp"

namespace shoal {

struct OrderToHelms {
  std::vector<std::string> vehicles;
  helm_command_t command{};
};

struct OrderToSims {
  std::vector<std::string> vehicles;
  sim_command_t command{};
};

/// A node message that is published in the name of a vehicle.
struct MessageOfVehicles {
  std::vector<std::string> vehicles;
  node_message_t message{};
};

struct OrderToBroker {
  const ControlRow* row = nullptr;
  unc_control_t control{};
  bool is_unregistered = false;  ///< Of a vehicle that the mission does not have.
};

struct OrderToClock {
  clock_command_t command{};
};

/// An [[order]] of the mission, or several of one name.
struct OrderByName {
  std::vector<OrderToHelms> orders;
};

using Order = std::variant<OrderToHelms, OrderToSims, MessageOfVehicles, OrderToBroker,
                           OrderToClock, OrderByName>;

/// The mission that orders are for.
struct OrderScope {
  std::string mission;
  std::vector<std::string> vehicles;
  int64_t mission_id = 0;  ///< Of the clock that answers; 0: any.
  std::map<std::string, std::vector<std::string>> groups = {};  ///< Members by group.
  bool is_playback = false;             ///< Of a recording: it takes orders to its clock alone.
  std::vector<OrderWords> orders = {};  ///< Those of the mission.
};

/// Returns what target and words ask for, or what is wrong with them. A target is a vehicle, "all",
/// "group:NAME", a rule of the broker, "clock", or, without words, an order of the mission; a
/// vehicle's name wins over a rule.
[[nodiscard]] Result<Order> ParseOrder(const OrderScope& scope, std::string_view target,
                                       std::span<const std::string> words);

/// Publishes the order to each that it is for.
void Publish(Bus& bus, const Order& order);

/// Returns where its addressees report on their pages what they made of it; nothing for the
/// clock, which answers by CLOCK_STATE, and for node messages.
[[nodiscard]] std::vector<OrderTrace> TracesOf(const Order& order);

/// Returns true for a vehicle of the mission, whatever the case of its letters.
[[nodiscard]] bool HasVehicle(const OrderScope& scope, std::string_view name);

}  // namespace shoal
