// A sea floor of measured depths: a grid, with straight lines between its points.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "lib/sea/ocean/grid_map.h"

namespace shoal {

class DepthGrid {
 public:
  /// `depths_m` in rows from South to North, each from West to East.
  /// @pre columns * rows finite depths
  DepthGrid(GridMap map, std::vector<float> depths_m);
  DepthGrid(const GridFrame& frame, std::vector<float> depths_m)
      : DepthGrid(GridMap(frame), std::move(depths_m)) {}

  /// Returns the depth of the floor, bilinear between the four points around a position, which is
  /// exact at the points, continuous, and never beyond the depths of those four. Off the grid it is
  /// that of the nearest point of the grid's edge. A NaN coordinate counts as the western or
  /// southern edge.
  [[nodiscard]] double DepthAt(const Eigen::Vector2d& position_m) const;

  /// Returns the least of the depths.
  [[nodiscard]] double ShallowestDepth() const { return shallowest_m_; }

  const GridMap& map() const { return map_; }

 private:
  GridMap map_;
  std::vector<float> depths_m_;
  double shallowest_m_;
};

}  // namespace shoal
