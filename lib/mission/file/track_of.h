// The recorded tracks of a mission's vehicles: read from their files, and laid on the mission's
// time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/model/mission.h"
#include "lib/mission/track/replay_track.h"

namespace shoal {

/// A track, and when of it the mission starts.
struct MissionTrack {
  ReplayTrack track;
  int64_t offset_us = 0;                   ///< Time of the track at step 0 of the mission.
  std::vector<std::string> warnings = {};  ///< Of what was read, and is probably meant otherwise.

  /// Returns where the vessel is this long after the mission's start.
  [[nodiscard]] ReplayState At(double mission_s) const;
};

/// Reads the track of a vehicle of model = "track", or returns why there is none: what is wrong
/// with the file, at which line, and what to do. The file's name ends in .csv or .gpx, in any case.
[[nodiscard]] Result<MissionTrack> TrackOf(const Mission& mission, const TrackOptions& options);

/// Returns where such a vehicle starts: depth 0 where it lies above the surface.
[[nodiscard]] StartPose StartOf(const MissionTrack& track);

}  // namespace shoal
