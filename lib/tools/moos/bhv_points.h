// Points and polygons as behavior files write them. Each key of a behavior takes some forms:
//
//   0,0 : 100,0 : 100,50                         also with a part `label,name`
//   pts={0,0:100,0:100,50}, label=name           lists also pts={x=0,y=0:x=100,y=0}
//   radial:: x=0, y=-75, radius=20, pts=8, snap=1         polygons; also format=radial, x=...
//   ellipse: x=0, y=0, major=40, minor=20, degs=45, pts=12, snap=1
//   wedge: x=0, y=0, lang=20, rang=80, range=50, pts=4
//   pylon: x1=0, y1=0, x2=0, y2=50, axis_pad=0, perp_pad=8
//   oval: x=60, y=-60, rad=15, len=60, ang=45
//   format=lawnmower, x=0, y=0, width=60, height=40, lane_width=10, rows=north-south, degs=0,
//       startx=0, starty=0                                lists; also lawnmower: x=...
//   format=bowtie, x=0, y=0, height=60, wid1=10, wid2=30, wid3=20, startx=50, starty=-100
//   zigzag: startx, starty, angle, length, period, amplitude, snap
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

struct BhvPoints {
  std::vector<Eigen::Vector2d> points_m;  ///< x East, y North; at most 10,000.
  std::string assumed;                    ///< What the text leaves open; may be empty.
};

/// Reads what Waypoint's `points` takes: a list or a polygon, which then begins with the vertex
/// nearest to the origin; none for "empty". The error names what is wrong and the forms above.
[[nodiscard]] Result<BhvPoints> ParseBhvPoints(std::string_view text);

/// Reads a list of points, not a polygon's form; at least one.
[[nodiscard]] Result<BhvPoints> ParseBhvSeglist(std::string_view text);

/// Reads a polygon, in its own order; it need not be convex. A circle's vertices are clockwise, the
/// first half a step behind North; an ellipse's counterclockwise.
[[nodiscard]] Result<BhvPoints> ParseBhvPolygon(std::string_view text);

/// Reads one point: "x,y", "x=1,y=2", "x:y"; the last of several.
[[nodiscard]] Result<BhvPoints> ParseBhvPoint(std::string_view text);

/// Returns [[x, y], ...] as TOML.
[[nodiscard]] std::string TomlPoints(const std::vector<Eigen::Vector2d>& points_m);

}  // namespace shoal
