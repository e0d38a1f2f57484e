// When a vehicle has reached a waypoint, by two HELM_STATE of it.
#pragma once

#include <string>

#include "shoal/helm_state_t.hpp"

namespace shoal {

/// Returns "waypoint 2 of survey reached", counted from 1, where the helm has turned to another
/// waypoint of its task or finished a lap between the two; else an empty text.
[[nodiscard]] std::string ArrivalText(const helm_state_t& before, const helm_state_t& now);

}  // namespace shoal
