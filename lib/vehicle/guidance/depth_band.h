// When a vehicle that drifts swims back to the depth that it keeps: the fins hold nothing without
// way, and a hull that is not neutral rises or sinks meanwhile.
#pragma once

#include <cmath>

namespace shoal {

/// Knows whether a vehicle must be under way to keep its depth.
class DepthBand {
 public:
  /// Takes how far from its depth the vehicle is. Returns true from kFar_m on until it is nearer
  /// than kNear_m. A Remus 100 whose buoyancy is 1 % more than its weight then stays within 1 m.
  bool IsLeft(double off_m) {
    if (std::abs(off_m) > kFar_m) is_left_ = true;
    if (std::abs(off_m) < kNear_m) is_left_ = false;
    return is_left_;
  }

 private:
  static constexpr double kFar_m = 0.25;
  static constexpr double kNear_m = 0.1;

  bool is_left_ = false;
};

}  // namespace shoal
