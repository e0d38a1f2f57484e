#include "lib/tools/view/vehicle_history.h"

#include <algorithm>
#include <limits>

namespace shoal {

namespace {

/// Ticks are whole microseconds; sums of them in seconds are not exact.
constexpr double kSlack_s = 1e-6;

void AddTo(std::deque<ChartPoint>* points, const ChartPoint& point, double step_s,
           size_t max_points) {
  if (!points->empty() && point.t_s < points->back().t_s + step_s - kSlack_s) return;
  if (points->size() == max_points) points->pop_front();
  points->push_back(point);
}

}  // namespace

void VehicleHistory::Add(double t_s, const nav_t& nav, const std::optional<desired_t>& desired) {
  if (!fine_.empty()) {
    if (t_s < fine_.back().t_s) {
      fine_.clear();
      coarse_.clear();
    } else if (t_s < fine_.back().t_s + kFineStep_s - kSlack_s) {
      return;
    }
  }
  const ChartPoint point = ChartPointOf(t_s, nav, desired);
  AddTo(&fine_, point, kFineStep_s, kMaxFine);
  AddTo(&coarse_, point, kCoarseStep_s, kMaxCoarse);
}

std::vector<ChartPoint> VehicleHistory::Window(double t_s, double window_s) const {
  const double begin_s = t_s - window_s;
  std::vector<ChartPoint> points;
  const auto add = [&](const std::deque<ChartPoint>& from, double before_s) {
    for (const ChartPoint& point : from) {
      if (point.t_s >= begin_s && point.t_s <= t_s && point.t_s < before_s) points.push_back(point);
    }
  };
  add(coarse_, fine_.empty() ? std::numeric_limits<double>::infinity() : fine_.front().t_s);
  add(fine_, std::numeric_limits<double>::infinity());
  ThinEvenly(&points, kMaxAnswer);
  return points;
}

ChartPoint ChartPointOf(double t_s, const nav_t& nav, const std::optional<desired_t>& desired) {
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
  ChartPoint point{
      .t_s = t_s,
      .heading_deg = static_cast<float>(nav.heading_deg),
      .desired_heading_deg = kUnknown,
      .speed_mps = static_cast<float>(nav.speed_mps),
      .desired_speed_mps = kUnknown,
      .depth_m = static_cast<float>(nav.z_m),
      .desired_depth_m = kUnknown,
      .altitude_m = nav.altitude_m < 0 ? kUnknown : static_cast<float>(nav.altitude_m)};
  if (desired) {
    point.desired_heading_deg = static_cast<float>(desired->heading_deg);
    point.desired_speed_mps = static_cast<float>(desired->speed_mps);
    point.desired_depth_m = static_cast<float>(desired->depth_m);
  }
  return point;
}

void ThinEvenly(std::vector<ChartPoint>* points, size_t max_points) {
  const size_t size = points->size();
  if (size <= max_points) return;
  const size_t stride = (size + max_points - 1) / max_points;
  size_t kept = 0;
  for (size_t i = (size - 1) % stride; i < size; i += stride) (*points)[kept++] = (*points)[i];
  points->resize(kept);
}

}  // namespace shoal
