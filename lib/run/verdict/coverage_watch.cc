#include "lib/run/verdict/coverage_watch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lib/vehicle/guidance/survey_lanes.h"

namespace shoal {

namespace {

constexpr double kCellsPerWidth = 20;
constexpr double kLeastCells = 40'000;
constexpr double kMaxCells = 4'000'000;
constexpr double kFastest_mps = 50;
constexpr double kPiecesPerReach = 40;

enum Cell : uint8_t { kOutside, kInside, kCovered };

/// Turns a point into the frame of the cells, by an angle that no lanes are likely to have.
Eigen::Vector2d Askew(const Eigen::Vector2d& point_m) {
  constexpr double kCos = 0.8506508083520399;  // Half the angle whose tangent is 2.
  constexpr double kSin = 0.5257311121191336;
  return {kCos * point_m.x() + kSin * point_m.y(), kCos * point_m.y() - kSin * point_m.x()};
}

}  // namespace

CoverageWatch::CoverageWatch(const std::vector<Polygon>& polygons_m, double sensor_width_m,
                             size_t num_vehicles)
    : reach_m_(sensor_width_m / 2), last_(num_vehicles) {
  std::vector<Polygon> askew_m;
  askew_m.reserve(polygons_m.size());
  std::vector<Eigen::AlignedBox2d> boxes_m;
  const auto num_polygons = static_cast<double>(polygons_m.size());
  for (const Polygon& polygon_m : polygons_m) {
    Polygon& turned_m = askew_m.emplace_back();
    Eigen::AlignedBox2d box_m;
    for (const Eigen::Vector2d& corner_m : polygon_m) {
      turned_m.push_back(Askew(corner_m));
      box_m.extend(turned_m.back());
    }
    Grid& grid = grids_.emplace_back();
    grid.cell_m = std::min(sensor_width_m / kCellsPerWidth,
                           std::sqrt(AreaOf_m2(polygon_m) * num_polygons / kLeastCells));
    grid.cell_m = std::max(grid.cell_m, std::sqrt(box_m.volume() * num_polygons / kMaxCells));
    // What another polygon has counted already counts once.
    std::vector<const Polygon*> others_m;
    for (size_t i = 0; i < boxes_m.size(); ++i) {
      if (boxes_m[i].intersects(box_m)) others_m.push_back(&askew_m[i]);
    }
    boxes_m.push_back(box_m);
    grid.corner_m = box_m.min();
    grid.columns = static_cast<int64_t>(std::ceil(box_m.sizes().x() / grid.cell_m));
    grid.rows = static_cast<int64_t>(std::ceil(box_m.sizes().y() / grid.cell_m));
    grid.cells.resize(static_cast<size_t>(grid.columns * grid.rows), kOutside);
    for (int64_t row = 0; row < grid.rows; ++row) {
      for (int64_t column = 0; column < grid.columns; ++column) {
        const Eigen::Vector2d middle_m =
            grid.corner_m + grid.cell_m * Eigen::Vector2d(static_cast<double>(column) + 0.5,
                                                          static_cast<double>(row) + 0.5);
        const bool is_counted =
            std::any_of(others_m.begin(), others_m.end(),
                        [&](const Polygon* other_m) { return IsInside(*other_m, middle_m); });
        if (is_counted || !IsInside(turned_m, middle_m)) continue;
        grid.cells[static_cast<size_t>(row * grid.columns + column)] = kInside;
        ++grid.num_inside;
      }
    }
  }
}

void CoverageWatch::Look(size_t vehicle, const Eigen::Vector2d& position_m, double time_s) {
  std::optional<Last>& last = last_[vehicle];
  const bool has_jumped =
      last && (position_m - last->seen_m).norm() > kFastest_mps * (time_s - last->time_s) + 1;
  if (!last || has_jumped) {
    last = {.position_m = position_m, .seen_m = position_m, .time_s = time_s};
    Cover(position_m, position_m);
    return;
  }
  last->seen_m = position_m;
  last->time_s = time_s;
  // Shorter pieces change next to nothing: on an arc of the reach as radius, less than 0.1 mm in 1
  // m.
  if ((position_m - last->position_m).norm() < reach_m_ / kPiecesPerReach) return;
  Cover(last->position_m, position_m);
  last->position_m = position_m;
}

void CoverageWatch::Cover(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  for (Grid& grid : grids_) CoverCells(Askew(from_m), Askew(to_m), &grid);
}

void CoverageWatch::CoverCells(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
                               Grid* grid) const {
  const auto cell_of = [&](double along_m, int64_t count) {
    const double cell = std::floor(along_m / grid->cell_m);
    return static_cast<int64_t>(std::clamp(cell, -1.0, static_cast<double>(count)));
  };
  const Eigen::Vector2d low_m = (from_m.cwiseMin(to_m) - grid->corner_m).array() - reach_m_;
  const Eigen::Vector2d high_m = (from_m.cwiseMax(to_m) - grid->corner_m).array() + reach_m_;
  const int64_t first_column = std::max<int64_t>(0, cell_of(low_m.x(), grid->columns));
  const int64_t last_column = std::min(grid->columns - 1, cell_of(high_m.x(), grid->columns));
  const int64_t first_row = std::max<int64_t>(0, cell_of(low_m.y(), grid->rows));
  const int64_t last_row = std::min(grid->rows - 1, cell_of(high_m.y(), grid->rows));
  const Eigen::Vector2d way_m = to_m - from_m;
  const double length2_m2 = way_m.squaredNorm();
  for (int64_t row = first_row; row <= last_row; ++row) {
    for (int64_t column = first_column; column <= last_column; ++column) {
      uint8_t& cell = grid->cells[static_cast<size_t>(row * grid->columns + column)];
      if (cell != kInside) continue;
      const Eigen::Vector2d middle_m =
          grid->corner_m + grid->cell_m * Eigen::Vector2d(static_cast<double>(column) + 0.5,
                                                          static_cast<double>(row) + 0.5);
      const Eigen::Vector2d from_start_m = middle_m - from_m;
      const double share =
          length2_m2 > 0 ? std::clamp(from_start_m.dot(way_m) / length2_m2, 0.0, 1.0) : 0;
      if ((from_start_m - share * way_m).squaredNorm() > reach_m_ * reach_m_) continue;
      cell = kCovered;
      ++grid->num_covered;
    }
  }
}

double CoverageWatch::covered_pct() const {
  double covered_m2 = 0;
  for (const Grid& grid : grids_) {
    covered_m2 += static_cast<double>(grid.num_covered) * grid.cell_m * grid.cell_m;
  }
  const double whole_m2 = area_m2();
  return whole_m2 > 0 ? 100 * covered_m2 / whole_m2 : 0;
}

double CoverageWatch::area_m2() const {
  double area_m2 = 0;
  for (const Grid& grid : grids_) {
    area_m2 += static_cast<double>(grid.num_inside) * grid.cell_m * grid.cell_m;
  }
  return area_m2;
}

double CoverageWatch::cell_m() const {
  double largest_m = 0;
  for (const Grid& grid : grids_) largest_m = std::max(largest_m, grid.cell_m);
  return largest_m;
}

}  // namespace shoal
