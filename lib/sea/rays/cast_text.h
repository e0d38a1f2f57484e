// Tables of water and of modems as users have them: CTD casts and packet error rates in CSV.
//
//   depth_m,temperature_degc,salinity_ppt     # or depth_m,speed_mps
//   0,18.2,34.9
//   5,18.1,35.0
//
// The first line names the columns, in any order, in any case, units after them or not; columns
// with other names are passed over. Comma, semicolon or tab separates; what follows # is a comment.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/sea/rays/sound_profile.h"

namespace shoal {

/// Returns the profile of a cast: `depth` and `speed`, or `depth`, `temperature` and `salinity` (by
/// Mackenzie). An error names file, line and remedy.
[[nodiscard]] Result<SoundProfile> ReadCast(std::string_view name, std::string_view text);

/// Returns the rows of a table of `snr_db` and `loss`, as they stand there.
[[nodiscard]] Result<std::vector<std::pair<double, double>>> ReadErrorTable(std::string_view name,
                                                                            std::string_view text);

}  // namespace shoal
