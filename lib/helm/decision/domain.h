// What a helm decides about: course and speed, and depth for vehicles that dive, each a row of
// evenly spaced values.
#pragma once

#include <algorithm>
#include <cmath>

namespace shoal {

/// Evenly spaced values of speed or depth.
struct Axis {
  double first = 0;
  double step = 1;  ///< > 0.
  int count = 0;    ///< 0: the helm does not decide about it.

  double At(int index) const { return first + step * index; }
  double Last() const { return At(count - 1); }
  /// Returns the index of the value nearest to `value`, the lower one of two.
  /// @pre count > 0
  int Nearest(double value) const {
    const double place = std::ceil((value - first) / step - 0.5);
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
  }

  bool operator==(const Axis&) const = default;
};

/// The grid of a helm's decisions. Course i is i whole degrees, compass.
struct Domain {
  static constexpr int kNumCourses = 360;

  Axis speed_mps = {.first = 0, .step = 0.1, .count = 41};  ///< first is 0.
  Axis depth_m = {};

  bool operator==(const Domain&) const = default;
};

}  // namespace shoal
