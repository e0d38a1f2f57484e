// The broker's status page, laid out as the node-comms manual shows it.
#pragma once

#include <cstdint>
#include <string>

#include "apps/shore_broker/acoustic_traffic.h"
#include "lib/comms/routing/router.h"

namespace shoal {

/// What the page shows besides what the router knows.
struct BrokerPageFacts {
  int64_t start_utime = 0;  ///< Of the broker's first step; rates count from here.
  int64_t now_utime = 0;
  int64_t num_commands_handed_on = 0;
  int64_t num_shared = 0;  ///< Reports on NODE_REPORT_UNC.
  int64_t num_undecodable = 0;
};

/// Returns configuration; of reports, messages, acks and packets: how many were received, sent, and
/// blocked by which cause; the vehicles that are known and stale; and the statistics of the
/// acoustic network, where anything went over it.
[[nodiscard]] std::string FormatBrokerPage(const Router& router, const AcousticTraffic& traffic,
                                           const BrokerPageFacts& facts);

}  // namespace shoal
