// What a channel of sound names in a mission file and does not hold: the sea floor, arrivals in a
// file.
#pragma once

#include <memory>

#include "lib/base/check/result.h"
#include "lib/mission/model/mission.h"
#include "lib/sea/acoustics/ray_channel.h"

namespace shoal {

/// Reads it, or returns why it cannot be read.
[[nodiscard]] Result<RaySurroundings> SurroundingsOf(const Mission& mission,
                                                     const RayChannelOptions& rays);

/// Returns the channel of [acoustics]; null where sound does not bend there, or something that it
/// names cannot be read.
[[nodiscard]] std::shared_ptr<RayChannel> MakeRayChannel(const Mission& mission);

}  // namespace shoal
