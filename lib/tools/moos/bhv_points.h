// Points and polygons as behavior files write them.
//
//   0,0 : 100,0 : 100,50                         also with a part `label,name`
//   pts={0,0:100,0:100,50}, label=name
//   radial:: x=0, y=-75, radius=20, pts=8, snap=1         also format=radial, x=...
//   ellipse:: x=0, y=0, major=40, minor=20, degs=45, pts=12, snap=1
//   format=lawnmower, x=0, y=0, width=60, height=40, lane_width=10, rows=north-south, degs=0,
//       startx=0, starty=0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

struct BhvPoints {
  std::vector<Eigen::Vector2d> points_m;  ///< x East, y North; at least one, at most 10,000.
  std::string assumed;                    ///< What the text leaves open; may be empty.
};

/// A circle's vertices are clockwise; the first is half a step behind North. The error names what
/// is wrong and the forms above.
[[nodiscard]] Result<BhvPoints> ParseBhvPoints(std::string_view text);

/// Returns [[x, y], ...] as TOML.
[[nodiscard]] std::string TomlPoints(const std::vector<Eigen::Vector2d>& points_m);

}  // namespace shoal
