// `shoal send VEHICLE COMMAND`: an order to helms, and their answers.
#pragma once

#include <string>
#include <vector>

#include "lib/bus/bus/lcm_bus.h"
#include "lib/run/orders/order.h"

namespace shoal {

/// Publishes the orders to their vehicles and prints what its helm publishes next; of the vehicles
/// `without_helm` that it has none, unless a program answers in its place. Returns the exit code:
/// kExitUsage where a helm refused, or none is there.
int SendHelm(LcmBus& bus, const OrderByName& named, const std::vector<std::string>& without_helm);

}  // namespace shoal
