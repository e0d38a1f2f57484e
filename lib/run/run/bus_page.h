// What a participant's page shows of the bus.
#pragma once

#include <cstdint>
#include <string>

#include "lib/bus/bus/bus.h"
#include "lib/run/run/status_page.h"
#include "lib/run/run/step_inbox.h"

namespace shoal {

struct BusFacts {
  BusCounters participant;  ///< Of one participant; all others are of its process.
  InboxCounters inbox;
  std::string first_forged;  ///< As StepInbox::first_forged.
  int64_t num_foreign = 0;   ///< Ticks and messages of other missions.
  int64_t num_forged = 0;    ///< Messages with a seal that is not genuine.
  int64_t num_requests = 0;  ///< Datagrams asked for again.
  int64_t num_refused = 0;   ///< Messages and datagrams of all kinds.
};

/// Adds the run warnings that follow from `facts`, and the line that begins with "Bus:".
void AppendBus(const BusFacts& facts, StatusPage* page);

}  // namespace shoal
