// Which courses and speeds keep a vessel inside a region.
#pragma once

#include "lib/base/geometry/convex_polygon.h"
#include "lib/helm/colregs/encounter_geometry.h"
#include "lib/helm/decision/allowed.h"

namespace shoal {

/// How far ahead, and how the vessel comes to a course.
struct LookAhead {
  double horizon_s = 5;    ///< > 0.
  double turn_degps = 10;  ///< It turns at this rate, by the shorter way; 0: at once.
};

/// Returns the courses and speeds with which a vessel at `own` stays inside the polygon up to the
/// horizon, to 1e-6 m: straight on from where it is, and along its turn to the course, both at the
/// new speed. From a place outside, those with which it is inside at the horizon, straight on. All
/// of them: empty.
///
/// From inside, a slower path is the same path, smaller, and so inside as well: the speeds of a
/// course reach from 0 to  min over edges of  room / reach,  reach the farthest that the path of
/// unit speed gets toward the edge. Straight at an edge at the distance d it is at most
/// d / horizon_s: the vessel does not cross where it can slow down by v / horizon_s.
/// @pre convex, at least three corners
[[nodiscard]] AllowedPart StayInside(const Polygon& polygon_m, const VesselMotion& own,
                                     const LookAhead& ahead, const Domain& domain);

}  // namespace shoal
