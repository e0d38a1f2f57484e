// `shoal send clock COMMAND`: pauses the mission, lets it go on, changes its warp.
#pragma once

#include "lib/bus/lcm_bus.h"
#include "lib/orders/order.h"

namespace shoal {

/// Publishes the order and prints what the clock does now. Returns the exit code: kExitUsage where
/// the clock refused, kExitEnvironment where it does not answer.
int SendClock(LcmBus& bus, const OrderToClock& order);

}  // namespace shoal
