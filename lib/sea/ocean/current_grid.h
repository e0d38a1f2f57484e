// A current on a grid: other water at another place, depth and time.
//
//   const CurrentGrid current({.map = map, .depths_m = {0, 10}, .times_s = {0, 3600}, ...});
//   Eigen::Vector2d water_mps = current.VelocityAt({x, y, z}, time_s);
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "lib/sea/ocean/grid_axis.h"
#include "lib/sea/ocean/grid_map.h"

namespace shoal {

/// Velocities at points: of each time each depth, of each depth each row from South to North, of
/// each row each column from West to East. On a map in degrees they run East and North at each
/// point, on another one along the mission's x and y. NaN: the point has no data.
struct CurrentGridData {
  GridMap map;
  std::vector<double> depths_m = {0};  ///< Ascending, positive below the surface.
  std::vector<double> times_s = {0};   ///< Ascending; since the mission's start.
  std::vector<float> east_mps = {};
  std::vector<float> north_mps = {};
};

class CurrentGrid {
 public:
  /// A point without data takes the velocity of the next point above it that has some; one with
  /// none above it is land, where the water stands still.
  /// @pre as many velocities of either kind as times, depths, rows and columns make; finite or NaN
  explicit CurrentGrid(CurrentGridData data);

  /// Returns the water's velocity along the mission's x and y: bilinear between the four points
  /// around the position, linear in depth and time, hence exact at the points and continuous. Off
  /// the grid it is that of the nearest edge, depth and time. @pre time_s is finite
  [[nodiscard]] Eigen::Vector2d VelocityAt(const Eigen::Vector3d& position_m, double time_s) const;

  /// Returns whether the position is at most half a cell beyond the outermost points.
  [[nodiscard]] bool IsInside(const Eigen::Vector2d& position_m) const;
  /// Returns whether none of the four points around the position has data at any depth or time.
  [[nodiscard]] bool IsLand(const Eigen::Vector2d& position_m) const;

  const GridMap& map() const { return map_; }
  double first_s() const { return times_s_.first(); }
  double last_s() const { return times_s_.last(); }
  /// One time: the current is steady.
  bool is_steady() const { return times_s_.count() == 1; }

 private:
  size_t LayerAt(int time, int depth) const;
  std::span<const float> Layer(const std::vector<float>& values, int time, int depth) const;
  void NoteWater();
  void FillGaps(std::vector<float>& values) const;
  Eigen::Vector2d LayerVelocity(const GridCell& cell, int time, int depth) const;
  Eigen::Vector2d ColumnVelocity(const GridCell& cell, int time, const GridPlace& depth) const;

  GridMap map_;
  GridAxis depths_m_;
  GridAxis times_s_;
  std::vector<float> east_mps_;
  std::vector<float> north_mps_;
  std::vector<bool> is_water_;  ///< Of each point of a layer: it has data somewhere.
};

}  // namespace shoal
