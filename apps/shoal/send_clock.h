// `shoal send clock COMMAND`: pauses and resumes the mission, changes its warp.
#pragma once

#include "lib/bus/bus/lcm_bus.h"
#include "lib/run/orders/order.h"

namespace shoal {

/// Publishes the order and prints the state of the clock. Returns the exit code: kExitUsage where
/// the clock refused, kExitEnvironment where it does not answer.
int SendClock(LcmBus& bus, const OrderToClock& order);

}  // namespace shoal
