// Where a vehicle was, from the start until now: bounded, and as dense at the start as at the end.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace shoal {

struct TrailPoint {
  double t_s = 0;
  float x_m = 0;
  float y_m = 0;
};

class Trail {
 public:
  static constexpr size_t kMaxPoints = 2000;
  static constexpr double kFirstStep_s = 0.5;

  /// Keeps the position where it is at least a step after the last one. The step doubles whenever
  /// there are kMaxPoints. A time before the last one starts again; positions that are not finite
  /// are ignored.
  void Add(double t_s, double x_m, double y_m) {
    if (!points_.empty() && t_s < next_s_ && t_s >= points_.back().t_s) return;
    Append(t_s, x_m, y_m);
  }

  std::span<const TrailPoint> points() const { return points_; }

 private:
  friend class IndexArchive;  ///< kept_index.cc, which writes and reads all of it.

  /// Ticks are whole microseconds; sums of them in seconds are not exact.
  static constexpr double kSlack_s = 1e-6;

  void Append(double t_s, double x_m, double y_m);

  double step_s_ = kFirstStep_s;
  double next_s_ = 0;  ///< Nothing is kept before.
  std::vector<TrailPoint> points_;
};

}  // namespace shoal
