// The causes of fates: one enumerator and one row each. Everything else that knows causes draws on
// this table: COMMS_FATES, mission files, the broker's page, texts of fates, the viewer and the
// tables of docs/reference/fates.md, which tests hold against it. A new cause: one enumerator, one
// row, and the place that decides (CONTRIBUTING.md).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lib/comms/routing/kind.h"

namespace shoal {

/// Every transmission gets exactly one of these at every destination: the first that holds, in the
/// order in which its kind asks (lib/comms/routing/decide.h).
enum class Cause : uint8_t {
  kDelivered,
  kInvalid,             ///< At intake: an illegal name, an impossible number, something missing.
  kTooManyVehicles,     ///< At intake: of an unregistered vehicle for which there is no room.
  kIgnoredGroup,        ///< At intake: `ignore_group`.
  kTooSoon,             ///< `min_msg_interval` of the source, `min_rpt_interval` of the pair.
  kTooLong,             ///< `max_msg_length`; acoustic: more than a packet holds.
  kUnknownSource,       ///< Of a vehicle that has sent no report, or was forgotten.
  kNoDestination,       ///< To a group without other members, or to oneself; or no other is known.
  kUnknownDestination,  ///< The named vehicle has sent no report, or was forgotten.
  kOtherGroup,          ///< `groups`, `msg_groups`.
  kStaleReceiver,       ///< The destination has been silent for too long.
  kOutOfRange,
  kDropped,  ///< `drop_percentage`.

  // Of the media, once the rules have let it pass.
  kInTransit,        ///< No fate yet.
  kNoMedium,         ///< The two have none in common of those that this traffic may use.
  kSubmerged,        ///< Radio: one of the two antennas is in the water.
  kBelowHorizon,     ///< Radio: the Earth's curvature hides one from the other.
  kWeakSignal,       ///< Radio: the path loss is greater than the receiver bears.
  kAlreadyReceived,  ///< Forwarded by a gateway: the destination has it, or had made it.
  kQueueFull,        ///< At a gateway or a modem, which has as much to send as it keeps.
  kHopLimit,         ///< At a gateway: as many as it allows have forwarded it.

  // Of an acoustic network.
  kNoChannel,     ///< The band has no channel for one of the two.
  kNotListening,  ///< The receiver does not receive on the channel.
  kNoPath,        ///< Farther than sound can come.
  kShadowZone,    ///< Sound bends away from the receiver.
  kHalfDuplex,    ///< The receiver was sending meanwhile.
  kCollision,     ///< Others overlapped it.
  kPacketLoss,
  kBitErrors,  ///< `crc`: it arrived damaged, and was thrown away.
  kRejected,   ///< Without `crc`: it arrived damaged, and makes no sense.
  kDamaged,    ///< Without `crc`: it arrived damaged, and was delivered so.
};

/// What a cause means for the destination.
enum class CauseOutcome : uint8_t { kWhole, kDamaged, kStopped, kPending };

struct CauseRow {
  Cause cause;
  std::string_view key;    ///< As COMMS_FATES and mission files write it.
  std::string_view label;  ///< On the broker's page.
  /// For people. What is before the first comma is the cause's name. Each part behind it holds
  /// numbers in braces (FateNumbers() of lib/tools/view/fate_text.h), and is left out where one of
  /// them played no part.
  std::string_view text;
  std::string_view color;  ///< In the viewer: "#rrggbb", of the palette of Okabe and Ito (2008).
  KindSet of_rules;        ///< The kinds to which the broker's rules can give it.
  KindSet of_network;      ///< The kinds to which media and gateways can give it.
  CauseOutcome outcome = CauseOutcome::kStopped;
};

namespace cause_table {

inline constexpr std::string_view kOrange = "#e69f00";
inline constexpr std::string_view kSkyBlue = "#56b4e9";
inline constexpr std::string_view kGreen = "#009e73";
inline constexpr std::string_view kYellow = "#f0e442";
inline constexpr std::string_view kBlue = "#0072b2";  // What is stopped at intake or by its source.
inline constexpr std::string_view kVermillion = "#d55e00";
inline constexpr std::string_view kPurple = "#cc79a7";
inline constexpr std::string_view kGrey = "#999999";

using enum Kind;
inline constexpr KindSet kNone{};
inline constexpr KindSet kAll = KindSet::All();
inline constexpr KindSet kAllButPackets{kReport, kMessage, kAck};

/// By the cause's number.
inline constexpr std::array kRows = {
    CauseRow{Cause::kDelivered, "delivered", "Delivered",
             "delivered, {range}, by {override}, {delay} by sound, {radio_delay} by radio, path "
             "loss {path_loss}",
             kGreen, kAll, kAll, CauseOutcome::kWhole},
    CauseRow{Cause::kInvalid, "invalid", "Invalid", "invalid", kBlue, kAll, kNone},
    CauseRow{Cause::kTooManyVehicles, "too_many_vehicles", "Too Many Vehicles", "too many vehicles",
             kBlue, KindSet(kReport, kMessage), kNone},
    CauseRow{Cause::kIgnoredGroup, "ignored_group", "Ignored Group", "of the ignored group", kBlue,
             KindSet(kReport), kNone},
    CauseRow{Cause::kTooSoon, "too_soon", "Too Recent", "too soon, {wait} too early", kBlue,
             KindSet(kReport, kMessage), kNone},
    CauseRow{Cause::kTooLong, "too_long", "Too Long", "too long, {length}", kBlue,
             KindSet(kMessage, kPacket), kAll},
    CauseRow{Cause::kUnknownSource, "unknown_source", "Missing Info (source)", "unknown source",
             kGrey, KindSet(kMessage, kAck, kPacket), KindSet(kReport)},
    CauseRow{Cause::kNoDestination, "no_destination", "No Destination", "no destination", kGrey,
             KindSet(kMessage, kPacket), KindSet(kReport)},
    CauseRow{Cause::kUnknownDestination, "unknown_destination", "Missing Info (destination)",
             "unknown destination", kGrey, KindSet(kMessage, kAck), kNone},
    CauseRow{Cause::kOtherGroup, "other_group", "Other Group", "other group", kSkyBlue,
             KindSet(kReport, kMessage), kNone},
    CauseRow{Cause::kStaleReceiver, "stale_receiver", "Stale Receiver",
             "stale receiver, silent for {age}", kGrey, kAllButPackets, kNone},
    CauseRow{Cause::kOutOfRange, "out_of_range", "Range Too Far",
             "out of range, {range}, horizon {horizon}", kVermillion, kAll, kAll},
    CauseRow{Cause::kDropped, "dropped", "Dropped", "dropped at random, {loss} are", kPurple,
             kAllButPackets, kNone},
    CauseRow{Cause::kInTransit, "in_transit", "In Transit", "in transit", kGrey, kNone, kNone,
             CauseOutcome::kPending},
    CauseRow{Cause::kNoMedium, "no_medium", "No Medium", "no medium in common", kSkyBlue, kNone,
             kAll},
    CauseRow{Cause::kSubmerged, "submerged", "Antenna Submerged",
             "antenna submerged, depth {depth}", kOrange, kNone, kAll},
    CauseRow{Cause::kBelowHorizon, "below_horizon", "Below Horizon",
             "below the radio horizon, {range}", kVermillion, kNone, kAll},
    CauseRow{Cause::kWeakSignal, "weak_signal", "Weak Signal",
             "signal too weak, {range}, path loss {path_loss}, horizon {horizon}", kVermillion,
             kNone, kAll},
    CauseRow{Cause::kAlreadyReceived, "already_received", "Received Already", "received already",
             kBlue, kNone, kAllButPackets},
    CauseRow{Cause::kQueueFull, "queue_full", "Queue Full", "queue full", kBlue, kNone, kAll},
    CauseRow{Cause::kHopLimit, "hop_limit", "Hop Limit", "too many gateways in turn", kBlue, kNone,
             kAllButPackets},
    CauseRow{Cause::kNoChannel, "no_channel", "No Channel", "no acoustic channel", kSkyBlue, kNone,
             kAll},
    CauseRow{Cause::kNotListening, "not_listening", "Not Listening",
             "receiver not listening, channel {channel}", kSkyBlue, kNone, kAll},
    CauseRow{Cause::kNoPath, "no_path", "No Path", "farther than sound comes", kVermillion, kNone,
             kAll},
    CauseRow{Cause::kShadowZone, "shadow_zone", "Shadow Zone",
             "shadow zone, probability of loss {loss_probability}, SNR {snr}", kVermillion, kNone,
             kAll},
    CauseRow{Cause::kHalfDuplex, "half_duplex", "Half Duplex",
             "receiver was sending, its own packet {own_packet}", kOrange, kNone, kAll},
    CauseRow{Cause::kCollision, "collision", "Collision", "collision, with {colliders}", kOrange,
             kNone, kAll},
    CauseRow{Cause::kPacketLoss, "packet_loss", "Packet Loss",
             "packet loss, probability {loss_probability}, SNR {snr}", kPurple, kNone, kAll},
    CauseRow{Cause::kBitErrors, "bit_errors", "Bit Errors",
             "bit errors, {bits} flipped, each with probability {bit_error_probability}", kYellow,
             kNone, kAll},
    CauseRow{Cause::kRejected, "rejected", "Rejected",
             "rejected as damaged, {bits} flipped, with {colliders}", kYellow, kNone,
             kAllButPackets},
    CauseRow{Cause::kDamaged, "damaged", "Delivered Damaged",
             "delivered damaged, {bits} flipped, with {colliders}", kYellow, kNone, kAll,
             CauseOutcome::kDamaged},
};

/// True where each row is at its cause's number and lacks nothing.
consteval bool IsComplete() {
  for (size_t i = 0; i < kRows.size(); ++i) {
    const CauseRow& row = kRows[i];
    if (static_cast<size_t>(row.cause) != i) return false;
    if (row.key.empty() || row.label.empty() || row.text.empty()) return false;
    if (row.color.size() != 7 || row.color.front() != '#') return false;
    const bool has_kind = !row.of_rules.empty() || !row.of_network.empty();
    if (has_kind == (row.outcome == CauseOutcome::kPending)) return false;
  }
  return true;
}
static_assert(IsComplete(), "each Cause has a row at its place, with key, label, text and colour");

}  // namespace cause_table

/// All causes, by their numbers.
inline constexpr const auto& kCauseTable = cause_table::kRows;
inline constexpr int kNumCauses = static_cast<int>(kCauseTable.size());

[[nodiscard]] constexpr const CauseRow& RowOf(Cause cause) {
  return kCauseTable[static_cast<size_t>(cause)];
}
/// Returns the cause's key: "out_of_range".
[[nodiscard]] constexpr std::string_view CauseText(Cause cause) { return RowOf(cause).key; }

/// Returns true where a transmission of this kind can have this fate.
[[nodiscard]] constexpr bool CanHave(Kind kind, Cause cause) {
  return RowOf(cause).of_rules.Has(kind) || RowOf(cause).of_network.Has(kind);
}

/// Returns true where the destination has received something, whole or damaged.
[[nodiscard]] constexpr bool IsReceived(Cause cause) {
  const CauseOutcome outcome = RowOf(cause).outcome;
  return outcome == CauseOutcome::kWhole || outcome == CauseOutcome::kDamaged;
}

}  // namespace shoal
