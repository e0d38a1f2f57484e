// The rules of the node-comms manual at one receiver: lib/comms/routing/decide.cc has each of them,
// and their order for each kind of transmission. docs/reference/fates.md lists the orders.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/comms/routing/contact.h"
#include "lib/comms/routing/fate.h"
#include "lib/comms/routing/rule_sequence.h"
#include "lib/comms/routing/rules.h"
#include "lib/comms/routing/transmission.h"

namespace shoal {

/// Returns the name of a source's random numbers for transmissions of one kind.
[[nodiscard]] StreamKey DropKey(uint64_t seed, Kind kind, std::string_view source_key);

/// Returns a transmission of `source`, from where it is for this kind.
[[nodiscard]] Transmission TransmissionOf(const RoutingRules& rules, uint64_t seed, Kind kind,
                                          int64_t number, const Contact& source);

/// Decides whether a receiver that is known receives a transmission of this kind. Source,
/// destination and counts are the caller's.
[[nodiscard]] Decision DecideAt(Kind kind, const LinkFacts& link);

/// Returns what the rules of this kind stop with, in the order in which they are asked; kDelivered
/// stands for a rule that delivers against those behind it.
[[nodiscard]] std::span<const Cause> OrderOfCauses(Kind kind);

/// What the rules decide for all receivers beyond a reach without looking at each: see
/// RuleSequence.
[[nodiscard]] bool CountsFar(const RoutingRules& rules, Kind kind);
[[nodiscard]] double Reach_m(const RoutingRules& rules, Kind kind, double stealth,
                             double max_earange);
[[nodiscard]] std::optional<Cause> CauseAt(const RoutingRules& rules, Kind kind,
                                           const Contact& receiver, int64_t utime);
/// Appends the fates that such receivers can have, with the limits that they have in common.
void AppendFarFates(const RoutingRules& rules, Kind kind, double reach_m,
                    std::vector<Decision>* fates);

/// Returns true where a vehicle silent since `received_utime` is stale at `utime`.
[[nodiscard]] bool IsStale(const RoutingRules& rules, int64_t received_utime, int64_t utime);

}  // namespace shoal
