// How one vehicle moved lately, for its charts.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "shoal/desired_t.hpp"
#include "shoal/nav_t.hpp"

namespace shoal {

/// One moment of a vehicle; not a number: not known.
struct ChartPoint {
  double t_s = 0;
  float heading_deg = 0;
  float desired_heading_deg = 0;
  float speed_mps = 0;
  float desired_speed_mps = 0;
  float depth_m = 0;
  float desired_depth_m = 0;
  float altitude_m = 0;
};

class VehicleHistory {
 public:
  static constexpr double kFineStep_s = 0.2;
  static constexpr size_t kMaxFine = 3000;  ///< Ten minutes.
  static constexpr double kCoarseStep_s = 1.8;
  static constexpr size_t kMaxCoarse = 2000;  ///< An hour.
  static constexpr size_t kMaxAnswer = 600;

  /// Takes the state at `t_s`, unless that is too soon after the last point. A time before the
  /// last one starts again.
  void Add(double t_s, const nav_t& nav, const std::optional<desired_t>& desired);

  /// Returns at most kMaxAnswer points of the `window_s` before and at `t_s`, evenly thinned.
  std::vector<ChartPoint> Window(double t_s, double window_s) const;

 private:
  std::deque<ChartPoint> fine_;
  std::deque<ChartPoint> coarse_;
};

/// Returns the point of a vehicle's state and its desired values.
[[nodiscard]] ChartPoint ChartPointOf(double t_s, const nav_t& nav,
                                      const std::optional<desired_t>& desired);
/// Keeps at most `max_points`, evenly over their number, the last among them.
void ThinEvenly(std::vector<ChartPoint>* points, size_t max_points);

}  // namespace shoal
