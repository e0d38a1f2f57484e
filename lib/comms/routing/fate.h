// What becomes of one transmission at one destination, and why.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lib/base/check/enum_table.h"
#include "lib/comms/routing/cause.h"
#include "lib/comms/routing/kind.h"

namespace shoal {

/// A rule that delivers a report against other rules.
enum class OverrideRule : uint8_t { kNone, kCriticalRange, kFullReport };

/// Returns what COMMS_FATES writes: "critical_range". The text of kNone is empty.
[[nodiscard]] constexpr std::string_view OverrideText(OverrideRule override_rule) {
  constexpr EnumTable<OverrideRule, std::string_view> kTexts = {"", "critical_range",
                                                                "full_report"};
  return kTexts[override_rule];
}

/// The index of no vehicle.
inline constexpr int32_t kNoContact = -1;
/// Stands for `count` destinations that are not distinguished.
inline constexpr int32_t kOthers = -2;

/// One fate and the numbers that decided; a number that played no part is -1.
struct Decision {
  int32_t source = kNoContact;       ///< Index of a contact.
  int32_t destination = kNoContact;  ///< Index of a contact, kOthers, or kNoContact: none known.
  int32_t unknown_name = -1;         ///< Where the destination is not a contact: index of its name.
  int32_t count = 1;                 ///< Destinations; more than 1 only for kOthers.
  int64_t number = 0;                ///< Of the transmission; counts per source and kind.
  Kind kind = Kind::kReport;
  Cause cause = Cause::kDelivered;
  OverrideRule override_rule = OverrideRule::kNone;
  double range_m = -1;
  double limit_m = -1;      ///< The range had to be less than this.
  double age_s = -1;        ///< Since the destination's last report.
  double age_limit_s = -1;  ///< The age had to be less than this.
  double wait_s = -1;       ///< kTooSoon: time remaining until it would not be too soon.
  double loss_pct = -1;     ///< It was lost with this probability.
  int64_t length_bytes = -1;
  int64_t length_limit_bytes = -1;  ///< The length had to be at most this.
  bool is_overheard = false;        ///< Of a message or an ack at a gateway that it is not for.

  bool operator==(const Decision&) const = default;
};

/// How many fates of each cause, by the cause's number.
using CauseCounts = std::array<int64_t, kNumCauses>;
/// The same for each kind.
using KindCounts = std::array<CauseCounts, kNumKinds>;

}  // namespace shoal
