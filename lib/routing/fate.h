// What becomes of one transmission at one destination, and why.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace shoal {

/// Every transmission gets exactly one of these at every destination.
enum class Cause : uint8_t {
  kDelivered,
  kInvalid,          ///< At intake: an illegal name or an impossible number.
  kTooManyVehicles,  ///< At intake: from one stranger more than there is room for.
  kStaleReceiver,    ///< The destination has been silent for too long.
  kOutOfRange,
};
inline constexpr int kNumCauses = 5;

/// Returns the cause as COMMS_FATES and mission files write it: "out_of_range".
[[nodiscard]] std::string_view CauseText(Cause cause);

/// The index of no vehicle.
inline constexpr int32_t kNobody = -1;

/// One fate and the numbers that decided; a number that played no part is -1.
struct Decision {
  int32_t source = kNobody;       ///< Index of a contact.
  int32_t destination = kNobody;  ///< Index of a contact; kNobody: refused at intake.
  int64_t number = 0;             ///< Of the transmission; counts per source.
  Cause cause = Cause::kDelivered;
  double range_m = -1;
  double limit_m = -1;      ///< The range had to be less than this.
  double age_s = -1;        ///< Since the destination's last report.
  double age_limit_s = -1;  ///< The age had to be less than this.
};

/// How many fates of each cause, by the cause's number.
using CauseCounts = std::array<int64_t, kNumCauses>;

}  // namespace shoal
