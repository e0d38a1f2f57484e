// `shoal send VEHICLE COMMAND`: an order to helms, and what they answer.
#pragma once

#include <string>
#include <vector>

#include "lib/bus/lcm_bus.h"
#include "shoal/helm_command_t.hpp"

namespace shoal {

/// Publishes to each vehicle and prints what its helm says next. Returns the exit code: kExitUsage
/// where a helm refused.
int SendHelm(LcmBus& bus, const std::vector<std::string>& vehicles, const helm_command_t& command);

}  // namespace shoal
