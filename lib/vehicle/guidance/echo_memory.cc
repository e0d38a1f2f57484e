#include "lib/vehicle/guidance/echo_memory.h"

#include <cmath>

#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

/// Nearer than this an echo has no direction.
constexpr double kHere_m = 1e-6;

int64_t CellOf(double coordinate_m) {
  return static_cast<int64_t>(std::floor(coordinate_m / EchoMemory::kCell_m));
}

}  // namespace

void EchoMemory::Take(const Eigen::Vector3d& position_m, std::span<const SonarEcho> echoes,
                      double time_s) {
  for (const SonarEcho& echo : echoes) {
    const Eigen::Vector3d place_m =
        Plausible(position_m) + Plausible(echo.range_m) * echo.direction;
    const std::array<int64_t, 3> cell = {CellOf(place_m.x()), CellOf(place_m.y()),
                                         CellOf(place_m.z())};
    if (places_.size() >= kMaxEchoes && !places_.contains(cell)) continue;
    places_[cell] = {.position_m = place_m, .time_s = time_s};
  }
}

std::span<const SonarEcho> EchoMemory::Recall(const Eigen::Vector3d& position_m, double time_s,
                                              double for_s) {
  std::erase_if(places_,
                [&](const auto& entry) { return std::abs(time_s - entry.second.time_s) > for_s; });
  echoes_.clear();
  for (const auto& [cell, place] : places_) {
    const Eigen::Vector3d way_m = place.position_m - Plausible(position_m);
    const double range_m = way_m.norm();
    if (range_m < kHere_m) continue;
    echoes_.push_back({.direction = way_m / range_m, .range_m = range_m});
  }
  return echoes_;
}

}  // namespace shoal
