// Convex polygons in the horizontal plane (x East, y North), corners in either direction.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace shoal {

using Polygon = std::vector<Eigen::Vector2d>;

/// Returns true where the corners follow each other clockwise, as seen on a chart.
[[nodiscard]] bool IsClockwise(const Polygon& polygon_m);

/// Returns true for at least three corners, all turning to the same side, and an area.
[[nodiscard]] bool IsConvex(const Polygon& polygon_m);

/// Returns the distance to the border, negative inside. @pre at least one corner
[[nodiscard]] double SignedDistance(const Polygon& polygon_m, const Eigen::Vector2d& position_m);

/// Returns the centre of the area, or the mean of the corners where there is none.
/// @pre at least one corner
[[nodiscard]] Eigen::Vector2d Centroid(const Polygon& polygon_m);

/// Returns the polygon, clockwise, with its edges moved out by `distance_m` and each corner
/// replaced by an arc about it with a point every 15 degrees at most.
/// @pre convex; distance_m >= 0
[[nodiscard]] Polygon Grown(const Polygon& polygon_m, double distance_m);

/// Returns how far it is from `position_m` along a compass heading to the border; nothing where the
/// ray misses it.
[[nodiscard]] std::optional<double> RayDistance(const Polygon& polygon_m,
                                                const Eigen::Vector2d& position_m,
                                                double heading_rad);

}  // namespace shoal
