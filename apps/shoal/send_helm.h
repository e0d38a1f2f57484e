// `shoal send VEHICLE COMMAND`: an order to helms, and their answers.
#pragma once

#include "lib/bus/lcm_bus.h"
#include "lib/orders/order.h"

namespace shoal {

/// Publishes to each vehicle and prints what its helm publishes next. Returns the exit code:
/// kExitUsage where a helm refused.
int SendHelm(LcmBus& bus, const OrderToHelms& order);

}  // namespace shoal
