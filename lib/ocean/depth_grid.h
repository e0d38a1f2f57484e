// A sea floor of measured depths: a grid, with straight lines between its points.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace shoal {

/// Where a grid's points are.
struct GridFrame {
  int columns = 1;                                         ///< Toward the East.
  int rows = 1;                                            ///< Toward the North.
  Eigen::Vector2d south_west_m = Eigen::Vector2d::Zero();  ///< The first point; x East, y North.
  Eigen::Vector2d cell_m = {1, 1};                         ///< From point to point; both > 0.
};

class DepthGrid {
 public:
  /// `depths_m` in rows from South to North, each from West to East.
  /// @pre columns * rows >= 1 finite depths, a finite frame
  DepthGrid(const GridFrame& frame, std::vector<float> depths_m);

  /// Returns the depth of the floor, bilinear between the four points around a position, which is
  /// exact at the points, continuous, and never beyond the depths of those four. Off the grid it is
  /// that of the nearest point of the grid's edge. A NaN coordinate counts as the western or
  /// southern edge.
  [[nodiscard]] double DepthAt(const Eigen::Vector2d& position_m) const;

  const GridFrame& frame() const { return frame_; }

 private:
  double Point(int column, int row) const;

  GridFrame frame_;
  std::vector<float> depths_m_;
};

}  // namespace shoal
