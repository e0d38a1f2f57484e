#include "lib/comms/routing/reach_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/check/check.h"

namespace shoal {

namespace {
/// Columns and rows beyond this are one: vehicles that far out are looked at more often than
/// needed.
constexpr int64_t kLastLine = int64_t{1} << 30;
}  // namespace

void ReachGrid::Reset(double side_m) {
  SHOAL_CHECK(side_m > 0, "the side of a square is positive");
  side_m_ = std::min(side_m, std::numeric_limits<double>::max());
  squares_.clear();
  places_.clear();
}

int64_t ReachGrid::Line(double coordinate_m) const {
  const double line = std::floor(coordinate_m / side_m_);
  const auto last = static_cast<double>(kLastLine);
  return static_cast<int64_t>(std::clamp(line, -last, last));
}

ReachGrid::Square ReachGrid::At(int64_t column, int64_t row) {
  return static_cast<uint64_t>(column + kLastLine) << 32 | static_cast<uint64_t>(row + kLastLine);
}

void ReachGrid::Put(int32_t index, const Eigen::Vector3d& position_m) {
  const auto place = static_cast<size_t>(index);
  if (place >= places_.size()) places_.resize(place + 1, kNowhere);
  const Square square = At(Line(position_m.x()), Line(position_m.y()));
  if (places_[place] == square) return;
  Remove(index);
  places_[place] = square;
  squares_[square].push_back(index);
}

void ReachGrid::Remove(int32_t index) {
  const auto place = static_cast<size_t>(index);
  if (place >= places_.size() || places_[place] == kNowhere) return;
  const auto found = squares_.find(places_[place]);
  std::erase(found->second, index);
  if (found->second.empty()) squares_.erase(found);
  places_[place] = kNowhere;
}

void ReachGrid::AppendNear(const Eigen::Vector3d& center_m, double reach_m,
                           std::vector<int32_t>* indices) const {
  const int64_t first_column = Line(center_m.x() - reach_m);
  const int64_t last_column = Line(center_m.x() + reach_m);
  const int64_t first_row = Line(center_m.y() - reach_m);
  const int64_t last_row = Line(center_m.y() + reach_m);
  const auto append = [indices](const std::vector<int32_t>& inhabitants) {
    indices->insert(indices->end(), inhabitants.begin(), inhabitants.end());
  };
  // Below 2^63: there are at most 2^31 + 1 lines of each kind.
  const int64_t num_squares = (last_column - first_column + 1) * (last_row - first_row + 1);
  if (num_squares > static_cast<int64_t>(squares_.size())) {
    for (const auto& [square, inhabitants] : squares_) {
      const int64_t column = static_cast<int64_t>(square >> 32) - kLastLine;
      const int64_t row = static_cast<int64_t>(square & 0xffffffff) - kLastLine;
      if (column >= first_column && column <= last_column && row >= first_row && row <= last_row) {
        append(inhabitants);
      }
    }
    return;
  }
  for (int64_t column = first_column; column <= last_column; ++column) {
    for (int64_t row = first_row; row <= last_row; ++row) {
      const auto found = squares_.find(At(column, row));
      if (found != squares_.end()) append(found->second);
    }
  }
}

}  // namespace shoal
