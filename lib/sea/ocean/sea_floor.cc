#include "lib/sea/ocean/sea_floor.h"

#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

SeaFloor::SeaFloor() : SeaFloor(FlatFloor(kDeepSea_m)) {}

SeaFloor::SeaFloor(std::shared_ptr<const DepthGrid> grid) : floor_(std::move(grid)) {
  SHOAL_CHECK(std::get<1>(floor_) != nullptr, "grid is not null");
}

double SeaFloor::DepthAt(const Eigen::Vector2d& position_m) const {
  if (const auto* noise = std::get_if<NoiseFloor>(&floor_)) return noise->DepthAt(position_m);
  return std::get<1>(floor_)->DepthAt(position_m);
}

double SeaFloor::ShallowestDepth() const {
  if (const auto* noise = std::get_if<NoiseFloor>(&floor_)) return noise->ShallowestDepth();
  return std::get<1>(floor_)->ShallowestDepth();
}

bool SeaFloor::Covers(const Eigen::Vector2d& position_m) const {
  const auto* grid = std::get_if<1>(&floor_);
  return grid == nullptr || (*grid)->map().Locate(position_m).IsInside();
}

bool SeaFloor::is_geographic() const {
  const auto* grid = std::get_if<1>(&floor_);
  return grid != nullptr && (*grid)->map().is_geographic();
}

SeaFloor FlatFloor(double depth_m) {
  NoiseFloorOptions options;
  options.style = FloorStyle::kFlat;
  options.z_m = depth_m;
  return SeaFloor(NoiseFloor(options, PerlinPermutation{}));
}

}  // namespace shoal
