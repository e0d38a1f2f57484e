#include "lib/sea/ocean/grid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

constexpr int kMaxBins = 1024;
constexpr int kBlockSide = 32;
constexpr double kSlack = 1e-9;  // Of a cell: a position on a border is in both cells.

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

GridMesh::GridMesh(const GeoPoint& origin, int columns, int rows,
                   const std::vector<double>& lats_deg, const std::vector<double>& lons_deg)
    : columns_(columns), rows_(rows) {
  SHOAL_CHECK(columns >= 2 && rows >= 2 && lats_deg.size() == At(0, rows) &&
                  lons_deg.size() == lats_deg.size(),
              "a mesh has at least two columns and rows, and a place for each of its points");
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const LocalFrame frame(origin);
  points_m_.reserve(lats_deg.size());
  for (size_t i = 0; i < lats_deg.size(); ++i) {
    points_m_.push_back(
        frame.ToLocal({.lat_deg = lats_deg[i], .lon_deg = std::remainder(lons_deg[i], 360)})
            .value_or(Eigen::Vector2d(kNan, kNan)));
  }
  MakeBins();
  MakeBlocks();
}

bool GridMesh::IsCell(int column, int row) const {
  return PointAt(column, row).allFinite() && PointAt(column + 1, row).allFinite() &&
         PointAt(column, row + 1).allFinite() && PointAt(column + 1, row + 1).allFinite();
}

int GridMesh::BinAlong(double distance_m, double bin_m) const {
  return static_cast<int>(std::clamp(distance_m / bin_m, 0.0, num_bins_ - 1.0));
}

template <class Use>
void GridMesh::ForBinsOf(int column, int row, const Use& use) const {
  const Eigen::Vector2d& a = PointAt(column, row);
  const Eigen::Vector2d& b = PointAt(column + 1, row);
  const Eigen::Vector2d& c = PointAt(column, row + 1);
  const Eigen::Vector2d& d = PointAt(column + 1, row + 1);
  const Eigen::Vector2d low = a.cwiseMin(b).cwiseMin(c).cwiseMin(d) - south_west_m_;
  const Eigen::Vector2d high = a.cwiseMax(b).cwiseMax(c).cwiseMax(d) - south_west_m_;
  const int last_y = BinAlong(high.y(), bin_m_.y());
  const int last_x = BinAlong(high.x(), bin_m_.x());
  for (int y = BinAlong(low.y(), bin_m_.y()); y <= last_y; ++y) {
    for (int x = BinAlong(low.x(), bin_m_.x()); x <= last_x; ++x) {
      use(static_cast<size_t>(y) * static_cast<size_t>(num_bins_) + static_cast<size_t>(x));
    }
  }
}

size_t GridMesh::CountInBins() const {
  size_t count = 0;
  for (int row = 0; row + 1 < rows_; ++row) {
    for (int column = 0; column + 1 < columns_; ++column) {
      if (!IsCell(column, row)) continue;
      const Eigen::Vector2d& a = PointAt(column, row);
      const Eigen::Vector2d& b = PointAt(column + 1, row);
      const Eigen::Vector2d& c = PointAt(column, row + 1);
      const Eigen::Vector2d& d = PointAt(column + 1, row + 1);
      const Eigen::Vector2d size_m =
          a.cwiseMax(b).cwiseMax(c).cwiseMax(d) - a.cwiseMin(b).cwiseMin(c).cwiseMin(d);
      const Eigen::Vector2d bins = size_m.cwiseQuotient(bin_m_) + Eigen::Vector2d(2, 2);
      count += static_cast<size_t>(bins.x()) * static_cast<size_t>(bins.y());
    }
  }
  return count;
}

void GridMesh::MakeBins() {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector2d& point : points_m_) {
    if (!point.allFinite()) continue;
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  if (low.allFinite()) {
    south_west_m_ = low;
    const Eigen::Vector2d size_m = (high - low).cwiseMax(1);
    const auto side = static_cast<int>(std::sqrt(static_cast<double>(points_m_.size())));
    // Cells that reach far, as in a damaged file, get few bins rather than much memory.
    for (num_bins_ = std::clamp(side, 1, kMaxBins);; num_bins_ /= 2) {
      bin_m_ = size_m / num_bins_;
      if (num_bins_ == 1 || CountInBins() <= 32 * points_m_.size()) break;
    }
  }
  bin_starts_.assign(static_cast<size_t>(num_bins_) * static_cast<size_t>(num_bins_) + 1, 0);
  const auto for_cells = [&](const auto& use) {
    for (int row = 0; row + 1 < rows_; ++row) {
      for (int column = 0; column + 1 < columns_; ++column) {
        if (!IsCell(column, row)) continue;
        ForBinsOf(column, row, [&](size_t bin) { use(bin, At(column, row)); });
      }
    }
  };
  for_cells([&](size_t bin, size_t) { ++bin_starts_[bin + 1]; });
  for (size_t bin = 1; bin < bin_starts_.size(); ++bin) bin_starts_[bin] += bin_starts_[bin - 1];
  bin_cells_.resize(bin_starts_.back());
  std::vector<size_t> next(bin_starts_.begin(), bin_starts_.end() - 1);
  for_cells(
      [&](size_t bin, size_t cell) { bin_cells_[next[bin]++] = static_cast<uint32_t>(cell); });
}

/// Returns the shares of a position between the points of a cell; nothing: it is not in the cell.
std::optional<GridMesh::Shares> GridMesh::SharesIn(int column, int row,
                                                   const Eigen::Vector2d& position_m) const {
  const Eigen::Vector2d& a = PointAt(column, row);
  const Eigen::Vector2d& b = PointAt(column + 1, row);
  const Eigen::Vector2d& c = PointAt(column, row + 1);
  const Eigen::Vector2d& d = PointAt(column + 1, row + 1);
  // Two triangles, on either side of the diagonal from b to c.
  const Eigen::Vector2d from_a = position_m - a;
  const double area_a = Cross(b - a, c - a);
  const double area_d = Cross(c - d, b - d);
  Shares shares;
  const auto is_in = [](double s, double t) {
    return s >= -kSlack && t >= -kSlack && s + t <= 1 + kSlack;
  };
  const Shares near_a = {.x = Cross(from_a, c - a) / area_a, .y = Cross(b - a, from_a) / area_a};
  const Eigen::Vector2d from_d = position_m - d;
  const Shares near_d = {.x = Cross(from_d, b - d) / area_d, .y = Cross(c - d, from_d) / area_d};
  if (area_a != 0 && is_in(near_a.x, near_a.y)) {
    shares = near_a;
  } else if (area_d != 0 && is_in(near_d.x, near_d.y)) {
    shares = {.x = 1 - near_d.x, .y = 1 - near_d.y};
  } else {
    return std::nullopt;
  }
  // Newton's method, from there; the triangles' shares where the cell is too bent for it.
  Shares better = shares;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector2d along_x = (b - a) * (1 - better.y) + (d - c) * better.y;
    const Eigen::Vector2d along_y = (c - a) * (1 - better.x) + (d - b) * better.x;
    const Eigen::Vector2d error_m = from_a - (b - a) * better.x - along_y * better.y;
    const double area = Cross(along_x, along_y);
    better.x += Cross(error_m, along_y) / area;
    better.y += Cross(along_x, error_m) / area;
  }
  const auto is_share = [](double share) { return share >= -1e-6 && share <= 1 + 1e-6; };
  if (is_share(better.x) && is_share(better.y)) shares = better;
  return Shares{.x = std::clamp(shares.x, 0.0, 1.0), .y = std::clamp(shares.y, 0.0, 1.0)};
}

void GridMesh::MakeBlocks() {
  for (int row = 0; row < rows_; row += kBlockSide) {
    for (int column = 0; column < columns_; column += kBlockSide) {
      Block block = {.column = column,
                     .row = row,
                     .low_m = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()),
                     .high_m = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity())};
      for (int y = row; y < std::min(row + kBlockSide, rows_); ++y) {
        for (int x = column; x < std::min(column + kBlockSide, columns_); ++x) {
          if (!PointAt(x, y).allFinite()) continue;
          block.low_m = block.low_m.cwiseMin(PointAt(x, y));
          block.high_m = block.high_m.cwiseMax(PointAt(x, y));
        }
      }
      if (block.low_m.allFinite()) blocks_.push_back(block);
    }
  }
}

/// Returns the nearest point, of equally near ones the first. Blocks that are too far away for it
/// are left out: otherwise a vehicle off the grid would have all points compared at each step.
size_t GridMesh::NearestIndex(const Eigen::Vector2d& position_m) const {
  double least = std::numeric_limits<double>::infinity();
  size_t nearest = 0;
  const auto distance_to = [&](const Block& block) {
    return (position_m - position_m.cwiseMax(block.low_m).cwiseMin(block.high_m)).squaredNorm();
  };
  const auto look_in = [&](const Block& block) {
    for (int y = block.row; y < std::min(block.row + kBlockSide, rows_); ++y) {
      for (int x = block.column; x < std::min(block.column + kBlockSide, columns_); ++x) {
        const double distance = (PointAt(x, y) - position_m).squaredNorm();
        // False for NaN.
        if (distance < least || (distance == least && At(x, y) < nearest)) {
          least = distance;
          nearest = At(x, y);
        }
      }
    }
  };
  const auto closest = std::ranges::min_element(blocks_, {}, distance_to);
  if (closest == blocks_.end() || !position_m.allFinite()) return nearest;
  look_in(*closest);
  // Its distance is rounded, and that of its points otherwise.
  constexpr double kRounding = 1e-12;
  for (const Block& block : blocks_) {
    if (&block != &*closest && distance_to(block) * (1 - kRounding) <= least) look_in(block);
  }
  return nearest;
}

GridCell GridMesh::NearestPoint(const Eigen::Vector2d& position_m) const {
  const size_t nearest = NearestIndex(position_m);
  const double least = (points_m_[nearest] - position_m).squaredNorm();
  const auto column = static_cast<int>(nearest % static_cast<size_t>(columns_));
  const auto row = static_cast<int>(nearest / static_cast<size_t>(columns_));
  double farthest_m2 = 0;
  for (const auto& [x, y] :
       {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
    if (column + x < 0 || column + x >= columns_ || row + y < 0 || row + y >= rows_) continue;
    const double distance = (PointAt(column + x, row + y) - points_m_[nearest]).squaredNorm();
    if (distance > farthest_m2) farthest_m2 = distance;
  }
  const bool is_inside = least <= farthest_m2 / 4;
  return {.x = {.before = column, .after = column, .is_inside = is_inside},
          .y = {.before = row, .after = row, .is_inside = is_inside}};
}

GridCell GridMesh::Locate(const Eigen::Vector2d& position_m) const {
  const Eigen::Vector2d from_m = position_m - south_west_m_;
  if (from_m.allFinite()) {
    const size_t bin =
        static_cast<size_t>(BinAlong(from_m.y(), bin_m_.y())) * static_cast<size_t>(num_bins_) +
        static_cast<size_t>(BinAlong(from_m.x(), bin_m_.x()));
    for (size_t i = bin_starts_[bin]; i < bin_starts_[bin + 1]; ++i) {
      const auto column = static_cast<int>(bin_cells_[i] % static_cast<uint32_t>(columns_));
      const auto row = static_cast<int>(bin_cells_[i] / static_cast<uint32_t>(columns_));
      if (const auto shares = SharesIn(column, row, position_m)) {
        return {.x = {.before = column, .after = column + 1, .share = shares->x},
                .y = {.before = row, .after = row + 1, .share = shares->y}};
      }
    }
  }
  return NearestPoint(position_m);
}

}  // namespace shoal
