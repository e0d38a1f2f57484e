#include "lib/run/verdict/separation_watch.h"

#include <algorithm>
#include <tuple>

namespace shoal {

void SeparationWatch::Look(std::span<const Sighting> vehicles, int64_t utime) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Vector2d lowest(kInfinity, kInfinity);
  Eigen::Vector2d highest = -lowest;
  for (const Sighting& sighting : vehicles) {
    if (!sighting.seen) continue;
    lowest = lowest.cwiseMin(sighting.position_m.head<2>());
    highest = highest.cwiseMax(sighting.position_m.head<2>());
  }
  const int axis = highest.y() - lowest.y() > highest.x() - lowest.x() ? 1 : 0;

  places_.clear();
  for (size_t i = 0; i < vehicles.size(); ++i) {
    if (vehicles[i].seen) places_.push_back({vehicles[i].position_m[axis], static_cast<int>(i)});
  }
  std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
    return std::tuple(a.along_m, a.vehicle) < std::tuple(b.along_m, b.vehicle);
  });

  for (size_t i = 0; i < places_.size(); ++i) {
    const auto& from = vehicles[static_cast<size_t>(places_[i].vehicle)].position_m;
    for (size_t j = i + 1; j < places_.size(); ++j) {
      if (places_[j].along_m - places_[i].along_m >= closest_.range_m) break;
      const auto& to = vehicles[static_cast<size_t>(places_[j].vehicle)].position_m;
      const double range_m = (to - from).norm();
      if (range_m >= closest_.range_m) continue;
      const auto [first, second] = std::minmax(places_[i].vehicle, places_[j].vehicle);
      closest_ = {.first = first, .second = second, .range_m = range_m, .utime = utime};
    }
  }
}

}  // namespace shoal
