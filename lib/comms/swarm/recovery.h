// The replacement of a field whose value is invalid.
//
//   RecoveryPlan plan;                                                  // muNet's
//   plan.of(SwarmField::kReporterPos) = {RecoveryStrategy::kPrevious};
//   if (const auto recovered = Recover(plan, {field, bad, subject}, {state, limits, now_us}))
//     Use(recovered->value);
//
// Strategies are tried in the plan's order; the first that has a value is taken. A field
// without any, and the strategy `skip`, drop the message. docs/communication/swarm.md shows what
// each strategy makes of each field.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "lib/comms/swarm/field_checks.h"
#include "lib/comms/swarm/group_state.h"
#include "lib/comms/swarm/report_message.h"
#include "lib/comms/swarm/swarm_field.h"

namespace shoal {

using RecoveryOrder = std::vector<RecoveryStrategy>;

struct RecoveryPlan {
  /// By the number of the field; muNet's.
  std::array<RecoveryOrder, kNumSwarmFields> by_field = MuNetOrders();

  RecoveryOrder& of(SwarmField field) { return by_field[static_cast<size_t>(field)]; }
  const RecoveryOrder& of(SwarmField field) const { return by_field[static_cast<size_t>(field)]; }

  [[nodiscard]] static std::array<RecoveryOrder, kNumSwarmFields> MuNetOrders();

  bool operator==(const RecoveryPlan&) const = default;
};

/// type; group_id; ids and counts; times in seconds; positions and velocities; rspn_sched.
using FieldValue =
    std::variant<MessageFlag, uint8_t, int64_t, double, Eigen::Vector3d, std::vector<int64_t>>;

/// The member that a field is about, as far as that is known.
struct FieldSubject {
  bool is_leader = false;
  std::optional<int64_t> id = {};  ///< Of a member.
};

/// A field whose value is invalid. It has the type that FieldValue names for the field.
struct DamagedField {
  SwarmField field = SwarmField::kType;
  FieldValue value = {};
  FieldSubject subject = {};
};

/// What there is to recover it from.
struct RecoverySources {
  const GroupState& state;
  const FieldLimits& limits;
  int64_t now_us = 0;  ///< The time that the value is for: positions are predicted up to here.
};

struct RecoveredField {
  FieldValue value = {};
  RecoveryStrategy strategy = RecoveryStrategy::kSkip;
};

/// With this many different bits or more a word is not taken for a damaged flag: one random word in
/// 240 is. (muNet takes up to 15, and two random words of three.)
inline constexpr int kFlagDistanceLimit_bits = 8;

/// Returns the flag that differs least, by fewer than kFlagDistanceLimit_bits bits.
[[nodiscard]] std::optional<MessageFlag> NearestFlag(const MessageFlag& flag);

/// Returns the replacement by one strategy; nothing where it has none.
[[nodiscard]] std::optional<FieldValue> RecoverBy(RecoveryStrategy strategy,
                                                  const DamagedField& damaged,
                                                  const RecoverySources& sources);

/// Returns the replacement by the first strategy of the plan that has one.
[[nodiscard]] std::optional<RecoveredField> Recover(const RecoveryPlan& plan,
                                                    const DamagedField& damaged,
                                                    const RecoverySources& sources);

}  // namespace shoal
