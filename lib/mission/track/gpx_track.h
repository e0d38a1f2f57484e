// Reads a track from GPX 1.0 or 1.1 (topografix.com/gpx.asp), the form in which plotters, watches
// and phones store where they were: the points <trkpt lat lon> of all segments of all tracks, each
// with a <time> in ISO 8601, one behind the other. <ele>, metres above the surface, is the depth
// with the other sign where the source is under water; else it is passed over, as all other
// elements are.
#pragma once

#include <string_view>

#include "lib/base/check/result.h"
#include "lib/mission/track/replay_track.h"
#include "lib/mission/track/track_builder.h"

namespace shoal {

/// Returns the track, or why there is none: "ferry.gpx:7: ...", with the remedy. A document with a
/// DOCTYPE is refused, so that it can define no entities that grow. @pre source.frame is not null
[[nodiscard]] Result<ReplayTrack> ParseGpxTrack(std::string_view text, const TrackSource& source);

}  // namespace shoal
