#include "lib/vehicle/vehicle/collision_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "lib/vehicle/vehicle/contact.h"

namespace shoal {

namespace {
/// An encounter is over where they are this many times as far apart as a collision is.
constexpr double kParted = 2;
}  // namespace

CollisionWatch::CollisionWatch(std::vector<double> lengths_m)
    : lengths_m_(std::move(lengths_m)), is_seen_(lengths_m_.size()) {}

double CollisionWatch::Allowed_m(uint32_t first, uint32_t second) const {
  return (lengths_m_[first] + lengths_m_[second]) / 2;
}

std::span<const Collision> CollisionWatch::Look(std::span<const uint32_t> seen,
                                                std::span<const Eigen::Vector3d> positions_m) {
  found_.clear();
  if (!touching_.empty()) {
    std::fill(is_seen_.begin(), is_seen_.end(), false);
    for (const uint32_t vehicle : seen) is_seen_[vehicle] = true;
    std::erase_if(touching_, [&](const auto& pair) {
      const auto& [first, second] = pair;
      return is_seen_[first] && is_seen_[second] &&
             (positions_m[first] - positions_m[second]).norm() > kParted * Allowed_m(first, second);
    });
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Vector2d lowest_m(kInfinity, kInfinity);
  Eigen::Vector2d highest_m = -lowest_m;
  double longest_m = 0;
  for (const uint32_t vehicle : seen) {
    lowest_m = lowest_m.cwiseMin(positions_m[vehicle].head<2>());
    highest_m = highest_m.cwiseMax(positions_m[vehicle].head<2>());
    longest_m = std::max(longest_m, lengths_m_[vehicle]);
  }
  const int axis = highest_m.y() - lowest_m.y() > highest_m.x() - lowest_m.x() ? 1 : 0;
  places_.clear();
  for (const uint32_t vehicle : seen) {
    const Eigen::Vector3d& position_m = positions_m[vehicle];
    places_.push_back({position_m[axis], position_m[1 - axis], vehicle});
  }
  std::sort(places_.begin(), places_.end(),
            [](const Place& a, const Place& b) { return a.along_m < b.along_m; });
  for (size_t i = 0; i < places_.size(); ++i) {
    for (size_t j = i + 1; j < places_.size(); ++j) {
      if (places_[j].along_m - places_[i].along_m >= longest_m) break;
      if (std::abs(places_[j].across_m - places_[i].across_m) >= longest_m) continue;
      const auto [first, second] = std::minmax(places_[i].vehicle, places_[j].vehicle);
      const Eigen::Vector3d& a_m = positions_m[first];
      const Eigen::Vector3d& b_m = positions_m[second];
      if (!InContact(a_m, lengths_m_[first], b_m, lengths_m_[second])) continue;
      if (!touching_.emplace(first, second).second) continue;
      found_.push_back({.first = first,
                        .second = second,
                        .range_m = (a_m - b_m).norm(),
                        .allowed_m = Allowed_m(first, second)});
    }
  }
  std::sort(found_.begin(), found_.end(), [](const Collision& a, const Collision& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return found_;
}

}  // namespace shoal
