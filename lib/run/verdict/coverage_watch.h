// Finds how much of an area vehicles have passed within reach of their sensors.
//
//   CoverageWatch watch({corners_m}, 20, 1);
//   watch.Look(0, position_m, time_s);   // once per step and vehicle
//   watch.covered_pct();
//
// The area is laid out in square cells; a cell is covered once its middle is within half of the
// sensor's width of a track. Cells are a twentieth of that width, or smaller, so that the area
// has 40,000 of them at least; larger only where its rectangle would need more than four million.
// They lie askew to the compass, so that lanes do not run along them and what is counted too much
// at some cells is counted too little at others.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace shoal {

class CoverageWatch {
 public:
  using Polygon = std::vector<Eigen::Vector2d>;

  /// Of the union of simple polygons, for that many vehicles. @pre sensor_width_m > 0
  CoverageWatch(const std::vector<Polygon>& polygons_m, double sensor_width_m, size_t num_vehicles);

  /// Takes where a vehicle is. Between two positions it went straight; one that it cannot have
  /// reached at 50 m/s begins a new track.
  void Look(size_t vehicle, const Eigen::Vector2d& position_m, double time_s);

  /// Returns the covered share of the area, in per cent.
  double covered_pct() const;
  double area_m2() const;
  /// Returns the side of the largest cells.
  double cell_m() const;

 private:
  /// One polygon's cells, row by row.
  struct Grid {
    Eigen::Vector2d corner_m = Eigen::Vector2d::Zero();  ///< Of the first cell, askew.
    double cell_m = 1;
    int64_t columns = 0;
    int64_t rows = 0;
    std::vector<uint8_t> cells = {};
    int64_t num_inside = 0;
    int64_t num_covered = 0;
  };
  struct Last {
    Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< Up to here the track is drawn.
    Eigen::Vector2d seen_m = Eigen::Vector2d::Zero();
    double time_s = 0;
  };

  void Cover(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
  void CoverCells(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, Grid* grid) const;

  double reach_m_;
  std::vector<Grid> grids_;
  std::vector<std::optional<Last>> last_;
};

}  // namespace shoal
