// How one vehicle moved in a whole log, for its charts: bounded, however long the log.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lib/tools/view/vehicle_history.h"

namespace shoal {

class RecordedChart {
 public:
  static constexpr size_t kMaxPoints = 16'384;
  static constexpr double kFirstStep_s = 0.1;

  /// Keeps the state at `t_s` where that is at least a step after the last point. The step
  /// doubles whenever there are kMaxPoints: 0.2 s in a log of half an hour.
  /// @pre t_s is not less than in the call before
  void Add(double t_s, const nav_t& nav, const std::optional<desired_t>& desired) {
    if (!points_.empty() && t_s < points_.back().t_s + step_s_ - kSlack_s) return;
    if (points_.size() == kMaxPoints) {
      for (size_t i = 0; i < kMaxPoints / 2; ++i) points_[i] = points_[2 * i];
      points_.resize(kMaxPoints / 2);
      step_s_ *= 2;
    }
    points_.push_back(ChartPointOf(t_s, nav, desired));
  }

  /// Returns at most VehicleHistory::kMaxAnswer points of the `window_s` before and at `t_s`.
  std::vector<ChartPoint> Window(double t_s, double window_s) const {
    const auto begin = std::lower_bound(
        points_.begin(), points_.end(), t_s - window_s - kSlack_s,
        [](const ChartPoint& point, double limit_s) { return point.t_s < limit_s; });
    const auto end = std::upper_bound(
        begin, points_.end(), t_s + kSlack_s,
        [](double limit_s, const ChartPoint& point) { return limit_s < point.t_s; });
    std::vector<ChartPoint> points(begin, end);
    ThinEvenly(&points, VehicleHistory::kMaxAnswer);
    return points;
  }

 private:
  friend class IndexArchive;  ///< kept_index.cc, which writes and reads all of it.

  /// Ticks are whole microseconds; sums of them in seconds are not exact.
  static constexpr double kSlack_s = 1e-6;

  double step_s_ = kFirstStep_s;
  std::vector<ChartPoint> points_;
};

}  // namespace shoal
