#include "lib/comms/swarm/field_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/leader_message.h"
#include "lib/comms/swarm/report_message.h"

namespace shoal {

namespace {

constexpr EnumTable<FieldFault, std::string_view> kFaultTexts = {
    "nothing",
    "wrong length",
    "not a type of message",
    "not a letter or digit",
    "not a 32-bit integer",
    "not positive",
    "too far from the own id",
    "the own id",
    "too many",
    "not a finite number",
    "farther than the limit",
    "faster than the limit",
    "before time 0",
    "later than the limit",
    "later than now",
    "in the past",
};

bool IsNear(int64_t id, std::optional<uint32_t> own_id, const FieldLimits& limits) {
  return !own_id || std::abs(id - int64_t{*own_id}) <= limits.max_id_distance;
}

FieldFault CheckId(int64_t id, std::optional<uint32_t> own_id, const FieldLimits& limits) {
  if (const FieldFault fault = CheckInteger(id); fault != FieldFault::kNone) return fault;
  if (id <= 0) return FieldFault::kNotPositive;
  return IsNear(id, own_id, limits) ? FieldFault::kNone : FieldFault::kFarFromOwnId;
}

FieldFault CheckVector(std::span<const double> vector, double limit, FieldFault beyond) {
  if (vector.size() != 3) return FieldFault::kWrongLength;
  if (const FieldFault fault = CheckNumbers(vector); fault != FieldFault::kNone) return fault;
  const bool is_within = std::all_of(vector.begin(), vector.end(),
                                     [&](double number) { return std::abs(number) <= limit; });
  return is_within ? FieldFault::kNone : beyond;
}

FieldFault CheckTime(double time_s, const FieldLimits& limits) {
  if (!std::isfinite(time_s)) return FieldFault::kNotFinite;
  if (time_s < 0) return FieldFault::kNegativeTime;
  return time_s < limits.max_time_s ? FieldFault::kNone : FieldFault::kTooLate;
}

}  // namespace

std::string_view TextOf(FieldFault fault) { return kFaultTexts[fault]; }

FieldFault CheckType(std::span<const uint8_t> flag) {
  if (flag.size() != std::tuple_size_v<MessageFlag>) return FieldFault::kWrongLength;
  for (const MessageFlag& known : {kReportFlag, kResponseFlag, kLeaderReportFlag, kBroadcastFlag}) {
    if (std::equal(flag.begin(), flag.end(), known.begin(), [](uint8_t byte, char letter) {
          return byte == static_cast<uint8_t>(letter);
        })) {
      return FieldFault::kNone;
    }
  }
  return FieldFault::kUnknownType;
}

FieldFault CheckGroupId(std::span<const uint8_t> group_id) {
  if (group_id.size() != 1) return FieldFault::kWrongLength;
  const char letter = static_cast<char>(group_id[0]);
  const bool is_alphanumeric = IsLetter(letter) || IsDigit(letter);
  return is_alphanumeric ? FieldFault::kNone : FieldFault::kNotAlphanumeric;
}

FieldFault CheckInteger(int64_t number) {
  const bool is_int32 = number >= std::numeric_limits<int32_t>::min() &&
                        number <= std::numeric_limits<int32_t>::max();
  return is_int32 ? FieldFault::kNone : FieldFault::kOutsideIntegers;
}

FieldFault CheckReporterId(int64_t id, std::optional<uint32_t> own_id, const FieldLimits& limits) {
  if (const FieldFault fault = CheckId(id, own_id, limits); fault != FieldFault::kNone) {
    return fault;
  }
  return own_id && id == int64_t{*own_id} ? FieldFault::kOwnId : FieldFault::kNone;
}

FieldFault CheckNumFollowers(int64_t number, const FieldLimits& limits) {
  if (number <= 0) return FieldFault::kNotPositive;
  return number <= limits.max_followers ? FieldFault::kNone : FieldFault::kTooMany;
}

FieldFault CheckSchedule(std::span<const int64_t> ids, std::optional<uint32_t> own_id,
                         const FieldLimits& limits) {
  for (const int64_t id : ids) {
    if (const FieldFault fault = CheckId(id, own_id, limits); fault != FieldFault::kNone) {
      return fault;
    }
  }
  return FieldFault::kNone;
}

FieldFault CheckNumbers(std::span<const double> numbers) {
  const bool are_finite = std::all_of(numbers.begin(), numbers.end(),
                                      [](double number) { return std::isfinite(number); });
  return are_finite ? FieldFault::kNone : FieldFault::kNotFinite;
}

FieldFault CheckPosition(std::span<const double> position_m, const FieldLimits& limits) {
  return CheckVector(position_m, limits.max_position_m, FieldFault::kTooFar);
}

FieldFault CheckVelocity(std::span<const double> velocity_mps, const FieldLimits& limits) {
  return CheckVector(velocity_mps, limits.max_speed_mps, FieldFault::kTooFast);
}

FieldFault CheckTimeStamp(double time_s, std::optional<int64_t> now_us, const FieldLimits& limits) {
  if (const FieldFault fault = CheckTime(time_s, limits); fault != FieldFault::kNone) return fault;
  const bool is_over = !now_us || Microseconds(time_s) <= *now_us + limits.future_tolerance_us;
  return is_over ? FieldFault::kNone : FieldFault::kFromTheFuture;
}

FieldFault CheckResponseStart(double time_s, std::optional<int64_t> now_us,
                              const FieldLimits& limits) {
  if (const FieldFault fault = CheckTime(time_s, limits); fault != FieldFault::kNone) return fault;
  const bool is_ahead = !now_us || Microseconds(time_s) >= *now_us - limits.late_start_us;
  return is_ahead ? FieldFault::kNone : FieldFault::kInThePast;
}

}  // namespace shoal
