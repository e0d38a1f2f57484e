#include "lib/sea/ocean/current_grid.h"

#include <cmath>
#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

Eigen::Vector2d Between(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double share) {
  return {std::lerp(from.x(), to.x(), share), std::lerp(from.y(), to.y(), share)};
}

}  // namespace

CurrentGrid::CurrentGrid(CurrentGridData data)
    : map_(std::move(data.map)),
      depths_m_(std::move(data.depths_m)),
      times_s_(std::move(data.times_s)),
      east_mps_(std::move(data.east_mps)),
      north_mps_(std::move(data.north_mps)) {
  SHOAL_CHECK(
      east_mps_.size() == LayerAt(times_s_.count(), 0) && north_mps_.size() == east_mps_.size(),
      "a current has times * depths * rows * columns velocities of either kind");
  for (size_t i = 0; i < east_mps_.size(); ++i) {
    // A vector with half of its data is none.
    if (std::isnan(east_mps_[i]) || std::isnan(north_mps_[i])) {
      east_mps_[i] = north_mps_[i] = std::nanf("");
    }
  }
  NoteWater();
  FillGaps(east_mps_);
  FillGaps(north_mps_);
}

/// Returns where the values of a layer begin.
size_t CurrentGrid::LayerAt(int time, int depth) const {
  return (static_cast<size_t>(time) * static_cast<size_t>(depths_m_.count()) +
          static_cast<size_t>(depth)) *
         map_.num_points();
}

std::span<const float> CurrentGrid::Layer(const std::vector<float>& values, int time,
                                          int depth) const {
  return std::span(values).subspan(LayerAt(time, depth), map_.num_points());
}

void CurrentGrid::NoteWater() {
  is_water_.assign(map_.num_points(), false);
  for (size_t i = 0; i < east_mps_.size(); ++i) {
    if (!std::isnan(east_mps_[i])) is_water_[i % map_.num_points()] = true;
  }
}

void CurrentGrid::FillGaps(std::vector<float>& values) const {
  for (int time = 0; time < times_s_.count(); ++time) {
    for (int depth = 0; depth < depths_m_.count(); ++depth) {
      const size_t begin = LayerAt(time, depth);
      for (size_t i = begin; i < begin + map_.num_points(); ++i) {
        if (std::isnan(values[i])) values[i] = depth == 0 ? 0 : values[i - map_.num_points()];
      }
    }
  }
}

Eigen::Vector2d CurrentGrid::LayerVelocity(const GridCell& cell, int time, int depth) const {
  return {map_.Interpolate(Layer(east_mps_, time, depth), cell),
          map_.Interpolate(Layer(north_mps_, time, depth), cell)};
}

Eigen::Vector2d CurrentGrid::ColumnVelocity(const GridCell& cell, int time,
                                            const GridPlace& depth) const {
  Eigen::Vector2d velocity_mps = LayerVelocity(cell, time, depth.before);
  if (depth.share != 0) {
    velocity_mps = Between(velocity_mps, LayerVelocity(cell, time, depth.after), depth.share);
  }
  return velocity_mps;
}

Eigen::Vector2d CurrentGrid::VelocityAt(const Eigen::Vector3d& position_m, double time_s) const {
  SHOAL_CHECK(std::isfinite(time_s), "time_s is finite");
  const GridCell cell = map_.Locate(position_m.head<2>());
  const GridPlace depth = depths_m_.Locate(position_m.z());
  const GridPlace time = times_s_.Locate(time_s);
  Eigen::Vector2d velocity_mps = ColumnVelocity(cell, time.before, depth);
  if (time.share != 0) {
    velocity_mps = Between(velocity_mps, ColumnVelocity(cell, time.after, depth), time.share);
  }
  return map_.TurnToPlane(velocity_mps, position_m.head<2>());
}

bool CurrentGrid::IsInside(const Eigen::Vector2d& position_m) const {
  return map_.Locate(position_m).IsInside();
}

bool CurrentGrid::IsLand(const Eigen::Vector2d& position_m) const {
  const GridCell cell = map_.Locate(position_m);
  for (const int row : {cell.y.before, cell.y.after}) {
    for (const int column : {cell.x.before, cell.x.after}) {
      const auto i = static_cast<size_t>(row) * static_cast<size_t>(map_.columns()) +
                     static_cast<size_t>(column);
      if (is_water_[i]) return false;
    }
  }
  return true;
}

}  // namespace shoal
