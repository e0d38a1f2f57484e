// A GPS receiver on a vehicle that dives: it needs its antenna out of the water, and time.
//
//            surfaced                    cold_fix_s or hot_fix_s later
//   under  ------------>  searching  ----------------------------------->  fixed
//     ^                      |                                               |
//     +----------------------+-----------------------------------------------+
//                           submerged: the last fix is remembered
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "lib/base/random/stream.h"

namespace shoal {

struct Gps {
  double antenna_depth_m = 0.3;  ///< Out of the water down to this depth of the vehicle, included.
  double cold_fix_s = 30;        ///< From surfacing to the first fix, >= 0 ...
  double hot_fix_s = 5;          ///< ... where the last one is at most hot_for_s old, >= 0.
  double hot_for_s = 7200;       ///< How long orbits and clock of the last fix are good for; >= 0.
  bool starts_hot = true;        ///< It had a fix just before the start.
  double noise_m = 0;            ///< Standard deviation of x and of y; >= 0.
  double rate_hz = 1;            ///< Positions per second; > 0.
};

class GpsUnit {
 public:
  GpsUnit(const Gps& gps, const StreamKey& key) : gps_(gps), key_(key) {}

  /// Takes note of the depth at `utime`; to be called in every step, times not decreasing.
  void Watch(double depth_m, int64_t utime);
  /// True where it knows its position, as of the last Watch.
  bool has_fix() const { return has_fix_; }
  /// Returns the position at `utime`, x East, y North; nothing without a fix.
  [[nodiscard]] std::optional<Eigen::Vector2d> Read(const Eigen::Vector2d& position_m,
                                                    int64_t utime) const;

 private:
  Gps gps_;
  StreamKey key_;
  std::optional<int64_t> start_utime_;     ///< Of the first Watch.
  std::optional<int64_t> surfaced_utime_;  ///< Absent: under water.
  std::optional<int64_t> fixed_utime_;     ///< Of the last moment with a fix.
  double wait_s_ = 0;                      ///< From surfacing to the fix, this time.
  bool has_fix_ = false;
};

}  // namespace shoal
