// Which courses and speeds keep a vessel inside a region.
#pragma once

#include <Eigen/Core>

#include "lib/decision/allowed.h"
#include "lib/geometry/convex_polygon.h"

namespace shoal {

/// Returns the courses and speeds with which a vessel, straight on from `position_m`, is inside the
/// polygon `horizon_s` later, to 1e-6 m; from a place inside, so all the way. All of them: empty.
///
/// At a distance d from an edge the speed toward it is at most d / horizon_s: so the vessel comes
/// to the edge in no finite time, where it can slow down by v / horizon_s.
/// @pre convex, at least three corners; horizon_s > 0
[[nodiscard]] Allowed StayInside(const Polygon& polygon_m, const Eigen::Vector2d& position_m,
                                 double horizon_s, const Domain& domain);

}  // namespace shoal
