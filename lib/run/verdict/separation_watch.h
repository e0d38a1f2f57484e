// Finds how close any two vehicles ever came.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace shoal {

/// Where a vehicle is, as far as it has been seen.
struct Sighting {
  bool seen = false;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down; finite.
};

/// Two vehicles, by index, and when they were how close.
struct Approach {
  int first = -1;
  int second = -1;  ///< > first; both -1: no two vehicles were seen.
  double range_m = std::numeric_limits<double>::infinity();
  int64_t utime = 0;
};

class SeparationWatch {
 public:
  /// Compares all pairs of `vehicles` with the closest so far. Sorts the vehicles along the longer
  /// side of their surroundings and looks only at those that are near along it: about n log n,
  /// where all pairs would be n^2.
  void Look(std::span<const Sighting> vehicles, int64_t utime);

  /// Returns the first closest approach of all times.
  const Approach& closest() const { return closest_; }

 private:
  struct Place {
    double along_m;
    int vehicle;
  };
  std::vector<Place> places_;
  Approach closest_;
};

}  // namespace shoal
