#include "lib/ocean/depth_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/check/check.h"

namespace shoal {

namespace {

/// A coordinate as the point before it and the share of the way to the next.
struct GridPlace {
  int before = 0;
  int after = 0;
  double share = 0;  ///< [0, 1].
};

GridPlace Locate(double offset_m, double cell_m, int count) {
  const double last = count - 1;
  // In this order max() turns NaN into the edge.
  const double cells = std::min(last, std::max(0.0, offset_m / cell_m));
  const int before = static_cast<int>(cells);
  return {.before = before, .after = std::min(before + 1, count - 1), .share = cells - before};
}

}  // namespace

DepthGrid::DepthGrid(const GridFrame& frame, std::vector<float> depths_m)
    : frame_(frame), depths_m_(std::move(depths_m)) {
  SHOAL_CHECK(frame.columns >= 1 && frame.rows >= 1, "a grid has at least one row and one column");
  SHOAL_CHECK(
      depths_m_.size() == static_cast<size_t>(frame.columns) * static_cast<size_t>(frame.rows),
      "a grid has columns * rows finite depths");
  SHOAL_CHECK(
      frame.cell_m.minCoeff() > 0 && frame.cell_m.allFinite() && frame.south_west_m.allFinite(),
      "a grid has a finite corner and positive cells");
}

double DepthGrid::Point(int column, int row) const {
  return depths_m_[static_cast<size_t>(row) * static_cast<size_t>(frame_.columns) +
                   static_cast<size_t>(column)];
}

double DepthGrid::DepthAt(const Eigen::Vector2d& position_m) const {
  const Eigen::Vector2d offset_m = position_m - frame_.south_west_m;
  const GridPlace east = Locate(offset_m.x(), frame_.cell_m.x(), frame_.columns);
  const GridPlace north = Locate(offset_m.y(), frame_.cell_m.y(), frame_.rows);
  return std::lerp(
      std::lerp(Point(east.before, north.before), Point(east.after, north.before), east.share),
      std::lerp(Point(east.before, north.after), Point(east.after, north.after), east.share),
      north.share);
}

}  // namespace shoal
