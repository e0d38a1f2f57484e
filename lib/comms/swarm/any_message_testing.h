// Any message of a swarm, by the flag that its bytes begin with.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "lib/comms/swarm/broadcast_message.h"

namespace shoal {

using AnySwarmMessage = std::variant<ReportMessage, LeaderMessage, BroadcastMessage>;

/// Returns the message; nothing if it is not one of RPRT, RSPN, LRPT and BCRQ, or too short.
[[nodiscard]] inline std::optional<AnySwarmMessage> DecodeAnyMessage(
    std::span<const uint8_t> bytes) {
  if (auto leader = DecodeLeaderReport(bytes)) return *leader;
  if (auto broadcast = DecodeBroadcast(bytes)) return *std::move(broadcast);
  auto report = DecodeReport(bytes);
  if (report && (report->flag == kReportFlag || report->flag == kResponseFlag)) return *report;
  return std::nullopt;
}

}  // namespace shoal
