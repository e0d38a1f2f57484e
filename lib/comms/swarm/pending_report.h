// What a message is going to change about one contact, once all of it has been checked.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "lib/comms/swarm/group_state.h"

namespace shoal {

/// A value that is missing was left out of the message (skip_field): the contact keeps its own.
struct PendingReport {
  std::optional<Eigen::Vector3d> position_m = {};
  std::optional<Eigen::Vector3d> velocity_mps = {};
  std::optional<Eigen::Vector3d> next_position_m = {};
  std::optional<Eigen::Vector3d> next_velocity_mps = {};
  std::optional<double> time_s = {};  ///< The time stamp.
};

/// Returns whether the contact has reported something newer than this.
[[nodiscard]] bool IsOutdated(const PendingReport& report, const SwarmContact& contact);

/// Takes the report. A value that is missing and was never known becomes a sentinel; a time stamp
/// later than `now_us` counts as now. Only reports with nothing missing and no sentinel are logged.
/// `next_*` counts for leaders only: @pre is_leader, or both are missing.
void ApplyReport(const PendingReport& report, bool is_leader, int64_t now_us,
                 SwarmContact* contact);

}  // namespace shoal
