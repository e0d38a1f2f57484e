// When a vehicle that drifts swims back to the depth that it keeps: the fins hold nothing without
// way, and a hull that is not neutral rises or sinks meanwhile.
#pragma once

#include <algorithm>
#include <cmath>

namespace shoal {

/// Knows whether a vehicle must be under way to keep its depth.
class DepthBand {
 public:
  /// Takes how far below its depth the vehicle is, `dt_s` after the last call. Returns true from
  /// kFar_m on until it is nearer than kNear_m. A Remus 100 whose buoyancy is 1 % more than its
  /// weight then stays within 1 m. A depth that it comes no nearer to for kGivesUp_s, as one below
  /// the floor, is given up for the one that it has.
  bool IsLeft(double off_m, double dt_s) {
    if (std::abs(off_m) < kNear_m) kept_off_m_ = 0;
    const double far_m = std::abs(off_m - kept_off_m_);
    if (far_m > kFar_m && !is_left_) {
      is_left_ = true;
      nearest_m_ = std::abs(off_m);
      still_s_ = 0;
    }
    if (far_m < kNear_m) is_left_ = false;
    if (!is_left_) return false;
    still_s_ += std::min(dt_s, 1.0);  // Longer ones are pauses.
    if (std::abs(off_m) < nearest_m_ - kProgress_m) {
      nearest_m_ = std::abs(off_m);
      still_s_ = 0;
    }
    if (still_s_ < kGivesUp_s) return true;
    kept_off_m_ = off_m;
    is_left_ = false;
    return false;
  }

 private:
  static constexpr double kFar_m = 0.25;
  static constexpr double kNear_m = 0.1;
  static constexpr double kProgress_m = 0.05;
  static constexpr double kGivesUp_s = 60;

  bool is_left_ = false;
  double kept_off_m_ = 0;  ///< Of the depth that it keeps instead.
  double nearest_m_ = 0;   ///< Since it was left.
  double still_s_ = 0;     ///< Since it came nearer.
};

}  // namespace shoal
