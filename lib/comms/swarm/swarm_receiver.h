// How a vehicle handles received bytes:
//
//   bytes -> frame, if the mission has frames -> type -> length -> group and sender
//         -> fields, damaged ones recovered by the plan -> the group's state, all at once
//
//   SwarmReceiver receiver{.state = state};
//   const SwarmReception reception = Receive(bytes, utime, &receiver);
//   if (reception.result == ReceptionResult::kRejected) Print(TextOf(reception.reason));
//
// A message is applied as a whole or not at all. received = clean + recovered + rejected.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/base/check/enum_table.h"
#include "lib/comms/swarm/field_checks.h"
#include "lib/comms/swarm/group_state.h"
#include "lib/comms/swarm/message_frame.h"
#include "lib/comms/swarm/recovery.h"
#include "lib/comms/swarm/swarm_field.h"

namespace shoal {

enum class ReceptionResult : uint8_t { kClean, kRecovered, kRejected };

/// Why a message was not applied.
enum class RejectReason : uint8_t {
  kNone,
  kBadFrame,       ///< Too short for a frame, or its checksum is wrong.
  kTooShort,       ///< Too short for a flag.
  kWrongLength,    ///< Not the length that its type has.
  kUnrecoverable,  ///< A field is damaged and no strategy has an answer.
  kOwnReport,      ///< Its sender id is that of this vehicle.
  kOtherGroup,
  kUnknownReporter,  ///< Its sender is not in the mission's list.
  kNoLeader,         ///< A leader's message, and this vehicle follows none.
  kOutdated,         ///< What is known of its sender is newer.
};
inline constexpr size_t kNumRejectReasons = kNumEnumerators<RejectReason>;

/// Returns the reason in words, "checksum is wrong"; "nothing" for kNone.
[[nodiscard]] std::string_view TextOf(RejectReason reason);

/// A field that was damaged, and what recovered it.
struct FieldRecovery {
  SwarmField field = SwarmField::kType;
  FieldFault fault = FieldFault::kNone;
  RecoveryStrategy strategy = RecoveryStrategy::kSkip;
  std::optional<int64_t> id = {};  ///< The member that a followers_* field is about.

  bool operator==(const FieldRecovery&) const = default;
};

/// What became of one message.
struct SwarmReception {
  ReceptionResult result = ReceptionResult::kRejected;
  RejectReason reason = RejectReason::kNone;
  std::optional<MessageFlag> flag = {};   ///< As recovered; nothing if it could not be read.
  std::optional<int64_t> sender = {};     ///< If it was found out.
  std::vector<FieldRecovery> recoveries;  ///< As they were checked; of a rejected message too.
  /// kUnrecoverable: which field, and why.
  std::optional<SwarmField> field = {};
  FieldFault fault = FieldFault::kNone;
};

struct ReceptionCounts {
  int64_t received = 0;
  int64_t clean = 0;
  int64_t recovered = 0;
  int64_t rejected = 0;
  std::array<int64_t, kNumRejectReasons> rejected_for = {};
  /// Of kUnrecoverable, by field.
  std::array<int64_t, kNumSwarmFields> unrecoverable = {};
  /// Fields of messages that were applied: [field][strategy].
  std::array<std::array<int64_t, kNumRecoveryStrategies>, kNumSwarmFields> recovered_by = {};
  FrameCounts frames = {};

  bool operator==(const ReceptionCounts&) const = default;
};

/// The receiver of one vehicle, with all of its state.
struct SwarmReceiver {
  GroupState state = {};
  RecoveryPlan plan = {};
  FieldLimits limits = {};
  bool has_frames = false;  ///< Whether messages come in frames (message_frame.h).
  ReceptionCounts counts = {};
};

/// Takes one message of any bytes. `receiver->state` changes only if the result is not kRejected,
/// and its numbers are finite then. `receiver->counts` always changes.
/// @pre now_us is within +-1e15
SwarmReception Receive(std::span<const uint8_t> bytes, int64_t now_us, SwarmReceiver* receiver);

}  // namespace shoal
