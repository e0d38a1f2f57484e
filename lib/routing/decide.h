// The rules of the node-comms manual, one after the other.
//
// A report at one receiver: full-report request, stale receiver, critical range, range, groups,
// drop_percentage, min_rpt_interval. (Critical range overrides all behind it.)
// A message at one receiver: msg_groups, stale receiver, range, drop_percentage. An ack likewise.
// A packet for the acoustic network at one receiver: range. All else is for the water to decide.
//
// The first rule that stops it is the cause; the numbers of all rules that were asked come with it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lib/random/stream.h"
#include "lib/routing/contact.h"
#include "lib/routing/fate.h"
#include "lib/routing/rules.h"

namespace shoal {

/// One transmission as it leaves its source.
struct Transmission {
  Kind kind = Kind::kReport;
  int64_t number = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  std::string_view group_key;
  double stealth = 1;
  /// DropKey of the source; absent: there is no drop_percentage.
  std::optional<StreamKey> link_key;
};

/// Returns the name of a source's random numbers for transmissions of one kind.
[[nodiscard]] StreamKey DropKey(uint64_t seed, Kind kind, std::string_view source_key);

/// Decides whether `receiver` hears a report. `delivered_utime`: when it last heard one of this
/// source, or kNever. `is_wanted`: it asked for the next one. Source, destination and counts are
/// the caller's.
[[nodiscard]] Decision DecideReport(const RoutingRules& rules, const Transmission& report,
                                    const Contact& receiver, int64_t delivered_utime,
                                    bool is_wanted, int64_t utime);

/// Decides whether `receiver`, which is known, hears a message or an ack.
[[nodiscard]] Decision DecideMessage(const RoutingRules& rules, const Transmission& message,
                                     const Contact& receiver, int64_t utime);

/// Decides whether `receiver`, which is known, may hear a packet: also where its position is old.
[[nodiscard]] Decision DecidePacket(const RoutingRules& rules, const Transmission& packet,
                                    const Contact& receiver);

/// Returns true where a vehicle silent since `received_utime` is stale at `utime`.
[[nodiscard]] bool IsStale(const RoutingRules& rules, int64_t received_utime, int64_t utime);

/// Returns `later_utime` - `earlier_utime` in seconds.
[[nodiscard]] inline double SecondsBetween(int64_t earlier_utime, int64_t later_utime) {
  return static_cast<double>(later_utime - earlier_utime) / 1e6;
}

}  // namespace shoal
