// Checks whether a member of the swarm can have sent a value. Limits are those of muNet's
// documentation; what lies within them passes, damaged or not.
//
//   if (const FieldFault fault = CheckPosition(position_m, limits); fault != FieldFault::kNone)
//     Print(TextOf(fault));
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "lib/base/check/enum_table.h"

namespace shoal {

/// Why a value is invalid.
enum class FieldFault : uint8_t {
  kNone,
  kWrongLength,
  kUnknownType,
  kNotAlphanumeric,
  kOutsideIntegers,
  kNotPositive,
  kFarFromOwnId,
  kOwnId,
  kTooMany,
  kNotFinite,
  kTooFar,
  kTooFast,
  kNegativeTime,
  kTooLate,
  kFromTheFuture,
  kInThePast,
};
inline constexpr size_t kNumFieldFaults = kNumEnumerators<FieldFault>;

/// Returns what is wrong, "farther than the limit"; "nothing" for kNone.
[[nodiscard]] std::string_view TextOf(FieldFault fault);

struct FieldLimits {
  double max_position_m = 1e5;     ///< Each coordinate.
  double max_speed_mps = 100;      ///< Each component.
  int64_t max_id_distance = 1000;  ///< From one's own id.
  int64_t max_followers = 1000;
  double max_time_s = 1e6;  ///< All times are below it.
  /// A time stamp may be later than now by this: as much as float32 rounds at 1e6 s, and more.
  int64_t future_tolerance_us = 100'000;
  /// The answers that a request asks for may have begun up to this long ago when it arrives. muNet
  /// does not check: with its default slots the first is over before a request to many has arrived.
  int64_t late_start_us = 0;

  bool operator==(const FieldLimits&) const = default;
};

/// type: four bytes, one of RPRT, RSPN, LRPT, BCRQ.
[[nodiscard]] FieldFault CheckType(std::span<const uint8_t> flag);

/// group_id: one byte, an ASCII letter or digit.
[[nodiscard]] FieldFault CheckGroupId(std::span<const uint8_t> group_id);

/// An int32.
[[nodiscard]] FieldFault CheckInteger(int64_t number);

/// reporter_id: a positive int32, near one's own id and not the same.
[[nodiscard]] FieldFault CheckReporterId(int64_t id, std::optional<uint32_t> own_id,
                                         const FieldLimits& limits);

/// num_followers: 1 to 1000.
[[nodiscard]] FieldFault CheckNumFollowers(int64_t number, const FieldLimits& limits);

/// rspn_sched: positive int32, near one's own id, which may be among them. Empty is right.
[[nodiscard]] FieldFault CheckSchedule(std::span<const int64_t> ids, std::optional<uint32_t> own_id,
                                       const FieldLimits& limits);

/// Finite numbers, any number of them.
[[nodiscard]] FieldFault CheckNumbers(std::span<const double> numbers);

/// *_pos: three coordinates of at most 100 km.
[[nodiscard]] FieldFault CheckPosition(std::span<const double> position_m,
                                       const FieldLimits& limits);

/// *_vel: three components of at most 100 m/s.
[[nodiscard]] FieldFault CheckVelocity(std::span<const double> velocity_mps,
                                       const FieldLimits& limits);

/// time_stamp, followers_rspn: at least 0, below 1e6 s, and, where now is given, not later than it.
[[nodiscard]] FieldFault CheckTimeStamp(double time_s, std::optional<int64_t> now_us,
                                        const FieldLimits& limits);

/// rspn_start: as a time stamp, but, where now is given, not earlier than it.
[[nodiscard]] FieldFault CheckResponseStart(double time_s, std::optional<int64_t> now_us,
                                            const FieldLimits& limits);

}  // namespace shoal
