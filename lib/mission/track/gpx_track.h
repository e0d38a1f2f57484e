// Reads a track from GPX 1.0 or 1.1 (topografix.com/gpx.asp), the form in which plotters, watches
// and phones store where they were: the points <trkpt lat lon> of all segments of all tracks, each
// with a <time> in ISO 8601, one behind the other; or those of the one track that the source
// chooses. <ele>, metres above the surface, is the depth with the other sign where the source is
// under water; else it is passed over, as all other elements are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/track/replay_track.h"
#include "lib/mission/track/track_builder.h"

namespace shoal {

/// Returns the track, or why there is none: "ferry.gpx:7: ...", with the remedy. What is read, and
/// probably meant otherwise, is added to `warnings`, if there are any. A document with a DOCTYPE is
/// refused, so that it can define no entities that grow; so is one that is nested deeper, or has
/// longer elements or more names, than GPX has. @pre source.frame is not null
[[nodiscard]] Result<ReplayTrack> ParseGpxTrack(std::string_view text, const TrackSource& source,
                                                std::vector<std::string>* warnings = nullptr);

}  // namespace shoal
