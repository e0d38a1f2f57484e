// How deep a vehicle may go, now and in a moment, over a floor that it knows ahead of itself.
//
//   DepthBound bound = BoundOver(profile, {.clearance_m = 5, .max_slope = 0.28, .speed_mps = 2});
//   FloorLine line;                      // an altimeter alone: what it saw gives the slope
//   line.Update(z_m + altitude_m, dt_s);
//   DepthBound bound = BoundOver(line.Ahead(20, 2), ...);
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace shoal {

/// A place of the sea floor on the vehicle's way.
struct FloorPoint {
  double ahead_m = 0;  ///< Along the way, >= 0.
  double z_m = 0;
};

/// The greatest depths allowed: here, kLead_s later, and a second after that, on the way that the
/// vehicle goes. Infinite: no bound.
struct DepthBound {
  static constexpr double kLead_s = 1.5;  ///< A pitch that is asked for is there after this.

  double now_m = std::numeric_limits<double>::infinity();
  double soon_m = std::numeric_limits<double>::infinity();
  double later_m = std::numeric_limits<double>::infinity();

  /// Returns the same depth at all times.
  static DepthBound Level(double z_m) { return {z_m, z_m, z_m}; }
};

struct Clearance {
  double clearance_m = 5;  ///< Kept above the floor, >= 0.
  double max_slope = 0.2;  ///< How steeply the vehicle climbs, metres per metre over ground; > 0.
  double speed_mps = 2;    ///< Over ground, >= 0.
};

/// Returns the bound that lets a vehicle climb over `floor`: at x
///
///   min over d >= 0 of floor(x + d) - clearance + max_slope d,
///
/// straight lines between the points. Whatever is steeper than max_slope is thus met with a climb
/// that begins in time, as far as `floor` reaches. No points: no bound.
/// @pre points finite, sorted by ahead_m
[[nodiscard]] DepthBound BoundOver(std::span<const FloorPoint> floor, const Clearance& clearance);

/// The floor under a vehicle, and how fast it comes up, from one altitude after another: a filter
/// of second order with fading memory (Brookner 1998, Tracking and Kalman Filtering Made Easy,
/// section 1.2.6), which follows a constant slope without lag.
class FloorLine {
 public:
  /// Takes the floor's depth as it was sensed, `dt_s` after the last. @pre finite, dt_s >= 0
  void Update(double floor_z_m, double dt_s);
  /// Forgets: the floor is not sensed.
  void Lose() { z_m_.reset(); }

  /// Returns the floor as a line as long as `length_m`; nothing where it is not known, one point
  /// where the vehicle is too slow to know a slope. @pre speed_mps >= 0, over ground
  [[nodiscard]] std::vector<FloorPoint> Ahead(double length_m, double speed_mps) const;

 private:
  std::optional<double> z_m_;
  double deepening_mps_ = 0;
};

}  // namespace shoal
