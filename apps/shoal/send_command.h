// `shoal send`: sends commands to a running mission from a shell.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/bus/bus/lcm_bus.h"

namespace shoal {

/// The period at which a wait for an answer polls the bus.
inline constexpr int64_t kSendPoll_us = 20'000;

struct SendOptions {
  int port_base = 0;   ///< 0: the one mission that runs.
  std::string target;  ///< A vehicle, "all", "group:NAME", "clock", or a rule such as comms_range.
  std::vector<std::string> words;  ///< Command and arguments, or the rule's vehicle and value.
};

/// Returns the exit code: kExitUsage also where a helm or the clock refused. Prints what was sent,
/// and the result where it can be seen.
int RunSend(const SendOptions& options);

/// Returns true where the bus works; else prints the error.
bool BusWorks(const LcmBus& bus);

}  // namespace shoal
