// The channels that metrics can be taken from.
#pragma once

#include <string_view>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns the row of "NAV_ALPHA". The error states that no vehicle of the mission has it, or that
/// it is not in a mission's log, so that a trial could not be judged again from there.
[[nodiscard]] Result<const ChannelRow*> FindMetricChannel(const Mission& mission,
                                                          std::string_view channel);

}  // namespace shoal
