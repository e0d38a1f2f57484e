// Reads one message against what a vehicle knows, and changes nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "lib/comms/swarm/pending_report.h"
#include "lib/comms/swarm/swarm_receiver.h"

namespace shoal {

/// Everything that an accepted message changes.
struct PendingUpdate {
  std::optional<int64_t> reporter =
      {};                ///< A member that has reported itself; else it is the leader.
  PendingReport report;  ///< Of the reporter, or of the leader.
  std::vector<std::pair<int64_t, PendingReport>> followers = {};

  bool is_request = false;             ///< The rest counts for requests only.
  std::vector<int64_t> order = {};     ///< Ids, in the order of their answers.
  bool is_order_known = false;         ///< Worth keeping: not damaged, or recovered.
  std::optional<double> start_s = {};  ///< Of the first answer.
};

/// Checks and recovers the message, without its frame. Returns what is to be changed; nothing where
/// the message is rejected. `reception` gets everything but the result.
[[nodiscard]] std::optional<PendingUpdate> ExamineMessage(std::span<const uint8_t> message,
                                                          int64_t now_us,
                                                          const SwarmReceiver& receiver,
                                                          SwarmReception* reception);

}  // namespace shoal
