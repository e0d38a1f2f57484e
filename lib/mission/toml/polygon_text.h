// Points and polygons as the texts that MOOS-IvP writes them in.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

/// Reads "0,0:100,0:100,50", also as "pts={0,0:100,0}"; x East, y North, m.
[[nodiscard]] Result<std::vector<Eigen::Vector2d>> ParsePoints(std::string_view text);

/// Reads the same, or a regular polygon: "radial:: x=0, y=0, radius=30, pts=8, snap=1". Its corners
/// are in the order of the compass, the first half a corner's angle east of North; `snap` rounds
/// them to its multiples.
[[nodiscard]] Result<std::vector<Eigen::Vector2d>> ParsePolygon(std::string_view text);

}  // namespace shoal
