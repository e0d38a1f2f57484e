#include "lib/vehicle/vehicle/obstacle_watch.h"

namespace shoal {

int TouchedObstacle(std::span<const Polygon> polygons_m, const Eigen::Vector2d& position_m,
                    double length_m) {
  if (!position_m.allFinite()) return -1;
  for (size_t i = 0; i < polygons_m.size(); ++i) {
    if (SignedDistance(polygons_m[i], position_m) < length_m / 2) return static_cast<int>(i);
  }
  return -1;
}

ObstacleWatch::ObstacleWatch(std::vector<double> lengths_m, std::vector<Polygon> polygons_m)
    : lengths_m_(std::move(lengths_m)), polygons_m_(std::move(polygons_m)) {}

std::span<const ObstacleHit> ObstacleWatch::Look(std::span<const uint32_t> seen,
                                                 std::span<const Eigen::Vector3d> positions_m) {
  found_.clear();
  if (polygons_m_.empty()) return found_;
  for (const uint32_t vehicle : seen) {
    for (uint32_t i = 0; i < polygons_m_.size(); ++i) {
      const double distance_m = SignedDistance(polygons_m_[i], positions_m[vehicle].head<2>());
      if (distance_m >= lengths_m_[vehicle]) {
        touching_.erase({vehicle, i});
      } else if (distance_m < lengths_m_[vehicle] / 2 && touching_.insert({vehicle, i}).second) {
        found_.push_back({.vehicle = vehicle,
                          .obstacle = i,
                          .distance_m = distance_m,
                          .allowed_m = lengths_m_[vehicle] / 2});
      }
    }
  }
  return found_;
}

}  // namespace shoal
