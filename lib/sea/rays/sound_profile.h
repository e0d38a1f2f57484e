// How fast sound travels at each depth, and what bends its rays.
//
//   const Result<SoundProfile> profile = SoundProfile::Make({{0, 1524}, {12, 1523.5}, {30, 1496}});
//   const double speed_mps = profile->SpeedAt(20);
//
// Between two points the speed is linear in depth, so that rays are arcs of circles there; above
// the first and below the last point it is constant.
#pragma once

#include <span>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

struct SpeedPoint {
  double depth_m = 0;  ///< Down from the surface.
  double speed_mps = 1500;

  bool operator==(const SpeedPoint&) const = default;
};

/// Limits of a point; they are beyond every sea.
inline constexpr double kMinRaySpeed_mps = 1000;
inline constexpr double kMaxRaySpeed_mps = 2000;
inline constexpr double kMaxProfileDepth_m = 12'000;
inline constexpr size_t kMaxProfilePoints = 10'000;

class SoundProfile {
 public:
  /// Sound travels at `speed_mps` everywhere. @pre within the limits above
  explicit SoundProfile(double speed_mps = 1500) : points_{{0, speed_mps}} {}

  /// Returns the profile through these points, or states which of them is wrong: depths must grow,
  /// in [0, kMaxProfileDepth_m], speeds must be between kMinRaySpeed_mps and kMaxRaySpeed_mps, and
  /// there are 1 to kMaxProfilePoints.
  static Result<SoundProfile> Make(std::vector<SpeedPoint> points);

  /// Returns the speed at this depth.
  [[nodiscard]] double SpeedAt(double depth_m) const;

  /// Returns the speed with which a straight path between two depths has the delay of the profile:
  /// the harmonic mean, which instruments call the mean speed of the water column.
  [[nodiscard]] double MeanSpeed(double depth_a_m, double depth_b_m) const;

  std::span<const SpeedPoint> points() const { return points_; }
  /// Returns whether the speed is the same at every depth.
  bool is_constant() const;

  bool operator==(const SoundProfile&) const = default;

 private:
  std::vector<SpeedPoint> points_;
};

/// The parameters of Munk's canonical profile.
struct MunkShape {
  double axis_depth_m = 1300;
  double axis_speed_mps = 1500;
  double scale_m = 1300;  ///< Of the stratification; > 0.
  double perturbation = 0.00737;

  bool operator==(const MunkShape&) const = default;
};

/// Returns Munk's profile from the surface to `depth_m`, with points at most `step_m` apart:
///   c = c1 (1 + eps (eta + exp(-eta) - 1)),  eta = 2 (z - z1) / B
/// Munk, W. H. (1974), Sound channel in an exponentially stratified ocean, with application to
/// SOFAR, J. Acoust. Soc. Am. 55(2), 220-226. The error names what is out of range.
[[nodiscard]] Result<SoundProfile> MunkProfile(const MunkShape& shape, double depth_m,
                                               double step_m);

/// Water as a probe measures it.
struct CastPoint {
  double depth_m = 0;
  double temperature_degc = 10;
  double salinity_ppt = 35;
};

/// Returns the profile of a cast, by Mackenzie's equation at each of its points (sound_speed.h).
/// The error names the point that is outside its range.
[[nodiscard]] Result<SoundProfile> ProfileOfCast(std::span<const CastPoint> cast);

}  // namespace shoal
