// A curvilinear grid: rows and columns of points, each at a latitude and a longitude of its own, as
// ocean models have them that follow a coast or have two North poles.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "lib/base/geodesy/local_frame.h"
#include "lib/sea/ocean/grid_cell.h"

namespace shoal {

class GridMesh {
 public:
  /// Points in rows, as they come. One whose latitude or longitude is NaN, or that is out of reach
  /// of the mission's plane, which touches the Earth at `origin`, has no place.
  /// @pre columns and rows >= 2, columns * rows of each; origin is finite and in range
  GridMesh(const GeoPoint& origin, int columns, int rows, const std::vector<double>& lats_deg,
           const std::vector<double>& lons_deg);

  /// Returns the cell that a position lies in, with its shares by inverse bilinear interpolation:
  /// exact at the points, continuous from cell to cell. Beyond all cells it is the nearest point,
  /// and inside where that is at most half as far as the point's neighbours.
  [[nodiscard]] GridCell Locate(const Eigen::Vector2d& position_m) const;

  int columns() const { return columns_; }
  int rows() const { return rows_; }

 private:
  struct Shares {
    double x = 0;
    double y = 0;
  };

  size_t At(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(columns_) + static_cast<size_t>(column);
  }
  const Eigen::Vector2d& PointAt(int column, int row) const { return points_m_[At(column, row)]; }
  bool IsCell(int column, int row) const;
  /// A rectangle of points, and where they lie.
  struct Block {
    int column = 0;  ///< The first one; kBlockSide of them, or up to the last.
    int row = 0;
    Eigen::Vector2d low_m;
    Eigen::Vector2d high_m;
  };

  void MakeBins();
  void MakeBlocks();
  size_t CountInBins() const;
  template <class Use>
  void ForBinsOf(int column, int row, const Use& use) const;
  int BinAlong(double distance_m, double bin_m) const;
  std::optional<Shares> SharesIn(int column, int row, const Eigen::Vector2d& position_m) const;
  size_t NearestIndex(const Eigen::Vector2d& position_m) const;
  GridCell NearestPoint(const Eigen::Vector2d& position_m) const;

  int columns_;
  int rows_;
  std::vector<Eigen::Vector2d> points_m_;  ///< NaN: without a place.
  Eigen::Vector2d south_west_m_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d bin_m_ = Eigen::Vector2d::Ones();
  int num_bins_ = 1;  ///< Along either side of a square of them around all points.
  /// The cells that touch bin b, by the numbers of their first points: those from bin_starts_[b] to
  /// bin_starts_[b + 1] of bin_cells_.
  std::vector<size_t> bin_starts_;
  std::vector<uint32_t> bin_cells_;
  std::vector<Block> blocks_;  ///< With a point that has a place; by rows.
};

}  // namespace shoal
