// Reads a track from a table of text.
//
//   t_s,x_m,y_m,heading_deg
//   0,10,-20,90
//   0.5,11,-20,90
//
// The first line names the columns, in any order and case; others than these are passed over:
//
//   time      utime (microseconds since 1970), utime_s (seconds since 1970); time, timestamp,
//             datetime (ISO 8601, or seconds); t_s, time_s (seconds). Of several the first in this
//             order counts.
//   place     lat_deg and lon_deg (latitude, longitude; lat, lon), WGS84; else x_m and y_m (x, y)
//   depth     depth_m (depth), or z_m (z), positive below the surface
//   heading   heading_deg (heading, hdg), true, clockwise from North
//   speed     speed_over_ground_mps (sog_mps), or speed_mps
//   vessel    mmsi, imo, callsign, vessel_name, vesselname, shipname, vessel_id, vessel, ship,
//   boat,
//             vehicle: a table of several vessels is read for the one that the source names
//
// Of a heading or a speed that is unknown (empty, NaN, null, none, na, n/a, -; a heading of 511, as
// in AIS) the points decide. NAV_<V>.csv of `shoal log csv` is such a table. Columns are separated
// by commas, else by semicolons, else by tabs; cells may be in double quotes. Lines that are
// blank or begin with # are passed over.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/track/replay_track.h"
#include "lib/mission/track/track_builder.h"

namespace shoal {

/// Returns the track, or why there is none: "ferry.csv:7: ...", with the remedy. What is read, and
/// probably meant otherwise, is added to `warnings`, if there are any. Takes memory for the points
/// that there are, whatever the text claims. @pre source.frame is not null
[[nodiscard]] Result<ReplayTrack> ParseCsvTrack(std::string_view text, const TrackSource& source,
                                                std::vector<std::string>* warnings = nullptr);

}  // namespace shoal
