// The fields of a swarm's messages, the ways to recover them, and what both are called in a mission
// file and in muNet's documentation.
//
//   NameOf(SwarmField::kReporterPos)  -> "reporter_pos"
//   RecoveryStrategyOf("predict")     -> RecoveryStrategy::kPredict
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lib/base/check/enum_table.h"

namespace shoal {

enum class SwarmField : uint8_t {
  kType,
  kGroupId,
  kReporterId,
  kReporterPos,
  kReporterVel,
  kTimeStamp,
  kLeaderPos,
  kLeaderVel,
  kLeaderNextPos,
  kLeaderNextVel,
  kNumFollowers,
  kFollowersPos,
  kFollowersVel,
  kFollowersRspn,
  kRspnSched,
  kRspnStart,
};
inline constexpr size_t kNumSwarmFields = kNumEnumerators<SwarmField>;

enum class RecoveryStrategy : uint8_t {
  kPredict,    ///< Predict it from what is known.
  kPrevious,   ///< Take the last known value.
  kNeutral,    ///< Take a harmless value.
  kSentinel,   ///< Mark it as unusable.
  kSkipField,  ///< Leave the field out and take the rest.
  kSkip,       ///< Drop the message.
};
inline constexpr size_t kNumRecoveryStrategies = kNumEnumerators<RecoveryStrategy>;

/// Names as the specification has them, in the order of the enumeration.
inline constexpr EnumTable<SwarmField, std::string_view> kSwarmFieldNames = {
    "type",          "group_id",      "reporter_id",   "reporter_pos",    "reporter_vel",
    "time_stamp",    "leader_pos",    "leader_vel",    "leader_next_pos", "leader_next_vel",
    "num_followers", "followers_pos", "followers_vel", "followers_rspn",  "rspn_sched",
    "rspn_start"};
inline constexpr EnumTable<RecoveryStrategy, std::string_view> kRecoveryStrategyNames = {
    "predict", "previous", "neutral", "sentinel", "skip_field", "skip"};

[[nodiscard]] std::string_view NameOf(SwarmField field);
[[nodiscard]] std::string_view NameOf(RecoveryStrategy strategy);

/// Returns nothing for a word that names none.
[[nodiscard]] std::optional<RecoveryStrategy> RecoveryStrategyOf(std::string_view name);

}  // namespace shoal
