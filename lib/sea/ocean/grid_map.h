// Where the points of a grid lie: in the plane of the mission, at latitudes and longitudes, on a
// projected map, or each at a place of its own.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>

#include "lib/base/geodesy/local_frame.h"
#include "lib/base/geodesy/map_projection.h"
#include "lib/sea/ocean/grid_axis.h"
#include "lib/sea/ocean/grid_cell.h"
#include "lib/sea/ocean/grid_mesh.h"

namespace shoal {

/// Where the points of a grid with even steps are.
struct GridFrame {
  int columns = 1;                                         ///< Toward the East.
  int rows = 1;                                            ///< Toward the North.
  Eigen::Vector2d south_west_m = Eigen::Vector2d::Zero();  ///< The first point; x East, y North.
  Eigen::Vector2d cell_m = {1, 1};                         ///< From point to point; both > 0.

  bool operator==(const GridFrame&) const = default;
};

class GridMap {
 public:
  /// @pre columns and rows >= 1, a finite corner, positive cells
  explicit GridMap(const GridFrame& frame);
  /// Axes in the mission's frame, metres, x East and y North.
  GridMap(GridAxis x_m, GridAxis y_m);
  /// Axes in degrees, WGS84: the mission's plane touches the Earth at `origin` (LocalFrame).
  /// Longitudes may count from anywhere: 190 is -170. @pre origin is finite and in range
  GridMap(const GeoPoint& origin, GridAxis lon_deg, GridAxis lat_deg);
  /// Axes in the coordinates of a projection. @pre likewise
  GridMap(const GeoPoint& origin, const MapProjection& projection, GridAxis x, GridAxis y);
  /// Points of a curvilinear grid.
  explicit GridMap(GridMesh mesh);

  /// Returns the points around a position; off the grid those of its nearest edge.
  [[nodiscard]] GridCell Locate(const Eigen::Vector2d& position_m) const;

  /// Returns as x, y of the mission's plane what runs `along` East and North at a position on a
  /// grid in degrees (LocalFrame::TurnToPlane). On other grids vectors are along x and y already.
  [[nodiscard]] Eigen::Vector2d TurnToPlane(const Eigen::Vector2d& along,
                                            const Eigen::Vector2d& position_m) const;

  /// Returns the value in a cell, bilinear between its four points: exact at the points,
  /// continuous, and never beyond the values of those four. `values` in rows from South to North,
  /// each from West to East. @pre columns() * rows() values
  [[nodiscard]] double Interpolate(std::span<const float> values, const GridCell& cell) const;

  int columns() const { return x_.count(); }
  int rows() const { return y_.count(); }
  size_t num_points() const { return static_cast<size_t>(columns()) * static_cast<size_t>(rows()); }
  /// Returns whether the points lie at latitudes and longitudes, given or by a projection.
  bool is_geographic() const { return earth_.has_value() || mesh_ != nullptr; }

 private:
  GridAxis x_;  ///< Metres, longitudes, or of a mesh the numbers of its points.
  GridAxis y_;  ///< Metres, latitudes, or likewise.
  std::optional<LocalFrame> earth_;
  std::optional<MapProjection> projection_;
  std::shared_ptr<const GridMesh> mesh_;  ///< Null: the grid has axes.
};

}  // namespace shoal
