// The bytes that a member of the swarm sends when its slot comes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/comms/swarm/field_checks.h"
#include "lib/comms/swarm/group_state.h"
#include "lib/comms/swarm/schedule.h"
#include "lib/vehicle/guidance/motion_prediction.h"
#include "shoal/helm_state_t.hpp"
#include "shoal/nav_t.hpp"

namespace shoal {

/// Returns how a vehicle moves over ground; x East, y North, z down. Nothing where NAV is not
/// finite, or not within the limits that the others check.
[[nodiscard]] std::optional<Motion> MotionOf(const nav_t& nav, const FieldLimits& limits);

/// Returns where the vehicle goes on to: its helm's waypoint, which it reaches as `plan` has it;
/// without one itself.
[[nodiscard]] Motion NextOf(const Motion& own, const helm_state_t& helm, const SpeedPlan& plan,
                            const FieldLimits& limits);

/// What a swarm message is made from.
struct SwarmMessageInputs {
  Motion own = {};
  Motion next = {};         ///< Of leaders.
  int64_t now_us = 0;       ///< Mission time since the start: the time stamp.
  const GroupState& state;  ///< Of the sender.
};

/// Returns the bytes of the message that is due, without a frame.
[[nodiscard]] std::vector<uint8_t> SwarmBytes(const DueMessage& due,
                                              const SwarmMessageInputs& inputs);

}  // namespace shoal
