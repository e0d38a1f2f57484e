// What becomes of one transmission at one destination, and why.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace shoal {

/// What is sent from vehicle to vehicle; each source numbers each kind from 0.
enum class Kind : uint8_t {
  kReport,
  kMessage,
  kAck,
  kPacket,  ///< Bytes for the acoustic network: ACOUSTIC_TX.
};
inline constexpr int kNumKinds = 4;

/// Every transmission gets exactly one of these at every destination: the first that holds, in the
/// order in which its kind asks (lib/routing/decide.h).
enum class Cause : uint8_t {
  kDelivered,
  kInvalid,          ///< At intake: an illegal name, an impossible number, something missing.
  kTooManyVehicles,  ///< At intake: from one stranger more than there is room for.
  kIgnoredGroup,     ///< At intake: `ignore_group`.
  kTooSoon,          ///< `min_msg_interval` of the source, `min_rpt_interval` of the pair.
  kTooLong,          ///< `max_msg_length`; over the acoustic network, more than a packet holds.
  kUnknownSource,    ///< Of a vehicle that has sent no report, or was forgotten.
  kStaleSource,      ///< A message of a vehicle that has been silent for too long.
  kNoDestination,    ///< To a group without other members, or to oneself; or nobody else is known.
  kUnknownDestination,  ///< The named vehicle has sent no report, or was forgotten.
  kOtherGroup,          ///< `groups`, `msg_groups`.
  kStaleReceiver,       ///< The destination has been silent for too long.
  kOutOfRange,
  kDropped,  ///< `drop_percentage`.

  // What goes over the acoustic network, once the rules have let it pass.
  kInTransit,     ///< No fate yet: it is in the water.
  kNoChannel,     ///< The band has no channel for one of the two.
  kNotListening,  ///< The receiver does not hear the channel; only in tdma_lf.
  kNoPath,        ///< Farther than sound can come.
  kHalfDuplex,    ///< The receiver was sending meanwhile.
  kCollision,     ///< Others overlapped it.
  kPacketLoss,
  kBitErrors,  ///< `crc`: it arrived damaged, and was thrown away.
  kRejected,   ///< Without `crc`: it arrived damaged, and makes no sense.
  kDamaged,    ///< Without `crc`: it arrived damaged, and was delivered so.
};
inline constexpr int kNumCauses = 24;
/// So many of them, the first, are the rules' own.
inline constexpr int kNumRuleCauses = 14;

/// A rule that delivers a report against other rules.
enum class OverrideRule : uint8_t { kNone, kCriticalRange, kFullReport };

/// Return what COMMS_FATES and mission files write: "report", "out_of_range", "critical_range".
/// The text of OverrideRule::kNone is empty.
[[nodiscard]] std::string_view KindText(Kind kind);
[[nodiscard]] std::string_view CauseText(Cause cause);
[[nodiscard]] std::string_view OverrideText(OverrideRule override_rule);

/// Returns true where a transmission of this kind can have this fate.
[[nodiscard]] bool CanHave(Kind kind, Cause cause);

/// The index of no vehicle.
inline constexpr int32_t kNobody = -1;
/// Stands for `count` destinations that are not told apart.
inline constexpr int32_t kOthers = -2;

/// One fate and the numbers that decided; a number that played no part is -1.
struct Decision {
  int32_t source = kNobody;       ///< Index of a contact.
  int32_t destination = kNobody;  ///< Index of a contact, kOthers, or kNobody: none that is known.
  int32_t unknown_name = -1;      ///< Where the destination is no contact: index of its name.
  int32_t count = 1;              ///< Destinations; more than 1 only for kOthers.
  int64_t number = 0;             ///< Of the transmission; counts per source and kind.
  Kind kind = Kind::kReport;
  Cause cause = Cause::kDelivered;
  OverrideRule override_rule = OverrideRule::kNone;
  double range_m = -1;
  double limit_m = -1;      ///< The range had to be less than this.
  double age_s = -1;        ///< Since the destination's last report; kStaleSource: the source's.
  double age_limit_s = -1;  ///< The age had to be less than this.
  double wait_s = -1;       ///< kTooSoon: so much too early.
  double loss_pct = -1;     ///< It was lost with this probability.
  int64_t length_bytes = -1;
  int64_t length_limit_bytes = -1;  ///< The length had to be at most this.

  bool operator==(const Decision&) const = default;
};

/// How many fates of each cause, by the cause's number.
using CauseCounts = std::array<int64_t, kNumCauses>;
/// The same for each kind.
using KindCounts = std::array<CauseCounts, kNumKinds>;

}  // namespace shoal
