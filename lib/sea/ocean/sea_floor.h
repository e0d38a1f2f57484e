// The sea floor, whatever it is made of. Cheap to copy: copies share a grid.
//
//   SeaFloor floor(NoiseFloor(options, StreamKey(seed, "floor")));
//   double z_floor = floor.DepthAt({x, y});
#pragma once

#include <Eigen/Core>
#include <memory>
#include <variant>

#include "lib/sea/ocean/depth_grid.h"
#include "lib/sea/ocean/noise_floor.h"

namespace shoal {

/// Depth of a sea whose floor no vehicle reaches.
inline constexpr double kDeepSea_m = 6000;

class SeaFloor {
 public:
  /// Flat, at kDeepSea_m.
  SeaFloor();
  explicit SeaFloor(const NoiseFloor& floor) : floor_(floor) {}
  /// @pre grid is not null
  explicit SeaFloor(std::shared_ptr<const DepthGrid> grid);

  /// Returns the floor's depth, z, >= 0, finite for every position: off a map, that of its edge.
  [[nodiscard]] double DepthAt(const Eigen::Vector2d& position_m) const;

  /// Returns a depth, >= 0, that the floor is nowhere above.
  [[nodiscard]] double ShallowestDepth() const;

  /// Returns whether the floor is known there: of a grid at most half a cell beyond its outermost
  /// points, of others everywhere.
  [[nodiscard]] bool Covers(const Eigen::Vector2d& position_m) const;
  /// Returns whether it is a grid of latitudes and longitudes.
  [[nodiscard]] bool is_geographic() const;

 private:
  std::variant<NoiseFloor, std::shared_ptr<const DepthGrid>> floor_;
};

/// Returns a flat floor. @pre 0 <= depth_m <= kMaxFloorDepth_m
[[nodiscard]] SeaFloor FlatFloor(double depth_m);

}  // namespace shoal
