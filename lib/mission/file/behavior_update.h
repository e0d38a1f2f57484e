// Updates of a running behavior, by the description of its table in the mission file.
#pragma once

#include <Eigen/Core>
#include <span>

#include "lib/base/check/result.h"
#include "lib/helm/behaviors/any_behavior.h"
#include "lib/helm/behaviors/update_text.h"

namespace shoal {

/// What BehaviorSet takes (update_text.h): applies all items to `options`, or returns what is wrong
/// with the first bad one. Beside the keys of the file these change what is there:
///
///   waypoint   point (the only one from now on), newpt (one more)
///   loiter     center_assign = x,y or present_position; xcenter_assign, ycenter_assign;
///              mod_poly_rad = metres, added to the radius of the polygon, which stays >= 5 m
///   station_keep   station_pt = present_position
[[nodiscard]] Result<BehaviorOptions> ReadBehaviorUpdate(const BehaviorOptions& options,
                                                         std::span<const UpdateItem> items,
                                                         const Eigen::Vector2d& position_m);

}  // namespace shoal
