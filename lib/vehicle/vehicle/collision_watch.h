// Finds the collisions of several vehicles, each encounter once.
//
//   CollisionWatch watch({3, 1.6});                  // lengths, metres
//   for (const Collision& collision : watch.Look(seen, positions_m)) ...
//
// Vehicles are numbers in the list of lengths.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace shoal {

/// Two vehicles that have just come into contact.
struct Collision {
  uint32_t first = 0;
  uint32_t second = 0;   ///< > first
  double range_m = 0;    ///< Between their centres.
  double allowed_m = 0;  ///< The mean of their lengths; > range_m.
};

class CollisionWatch {
 public:
  /// @pre lengths >= 0
  explicit CollisionWatch(std::vector<double> lengths_m);

  /// Takes the positions of the vehicles in `seen`, at one and the same time, and returns the
  /// encounters that begin there, in order of their numbers: InContact
  /// (lib/vehicle/vehicle/contact.h), unless the two have touched before and were never twice as
  /// far apart since. Sorts along the longer side of the area and compares only those that are near
  /// along it and across. Valid until the next call. @pre `seen` holds each number once;
  /// `positions_m` has one finite position per length
  [[nodiscard]] std::span<const Collision> Look(std::span<const uint32_t> seen,
                                                std::span<const Eigen::Vector3d> positions_m);

 private:
  struct Place {
    double along_m;
    double across_m;
    uint32_t vehicle;
  };

  double Allowed_m(uint32_t first, uint32_t second) const;

  std::vector<double> lengths_m_;
  std::set<std::pair<uint32_t, uint32_t>> touching_;  ///< Of encounters that are not over.
  std::vector<bool> is_seen_;
  std::vector<Place> places_;
  std::vector<Collision> found_;
};

}  // namespace shoal
