// The bytes on the air of what vehicles send to each other, and what a receiver decodes where they
// arrive damaged.
//
//   node report    muNet's REPORT, 37 bytes (lib/comms/swarm/report_message.h)
//   node message   its text, as MOOS writes it: src_node=alpha,dest_node=bravo,var_name=...
//   ack            its text: src_node=bravo,dest_node=alpha,ack_id=...
//   packet         its payload
//
// What arrives undamaged is handed on as it came to the broker: the air carries less of it, and
// takes the time for that.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/geodesy/local_frame.h"
#include "shoal/ack_message_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/node_report_t.hpp"

namespace shoal {

/// Positions beyond this and speeds beyond that are taken for damage, as in muNet.
inline constexpr double kPlausiblePosition_m = 1e5;
inline constexpr double kPlausibleSpeed_mps = 100;

/// Returns 37 bytes. `address` is the sender's; times are counted from `start_utime`.
[[nodiscard]] std::vector<uint8_t> AirBytes(const node_report_t& report, uint32_t address,
                                            int64_t start_utime);
[[nodiscard]] std::vector<uint8_t> AirBytes(const node_message_t& message);
[[nodiscard]] std::vector<uint8_t> AirBytes(const ack_message_t& ack);

/// What is needed to decode a damaged report.
struct ReportContext {
  std::string_view receiver;
  int64_t start_utime = 0;
  int64_t now_utime = 0;
  GeoPoint origin;  ///< Of the mission's plane.
  /// The vehicle with this address; empty: none.
  std::function<std::string_view(uint32_t)> vehicle_at;
};

/// Returns `report` with those members changed whose bytes differ between `sent` and `arrived`, or
/// nothing where a receiver would see that it is wrong: no report, no vehicle's address or the
/// receiver's own, a group that no letter stands for, numbers that are not finite, beyond
/// kPlausiblePosition_m, kPlausibleSpeed_mps or the future.
[[nodiscard]] std::optional<node_report_t> UnderstandDamaged(const node_report_t& report,
                                                             std::span<const uint8_t> sent,
                                                             std::span<const uint8_t> arrived,
                                                             const ReportContext& context);

/// Returns the message in the damaged text, or nothing where it is not a message (MOOS's syntax,
/// and what the broker requires of every message). `message` supplies what the air does not carry.
[[nodiscard]] std::optional<node_message_t> UnderstandDamaged(const node_message_t& message,
                                                              std::span<const uint8_t> arrived);
[[nodiscard]] std::optional<ack_message_t> UnderstandDamaged(const ack_message_t& ack,
                                                             std::span<const uint8_t> arrived);

}  // namespace shoal
