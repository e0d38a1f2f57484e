#include "lib/vehicle/control/floor_ahead.h"

#include <algorithm>

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

namespace {

/// Time constant of FloorLine's memory: short beside the time that a slope of 1:8 at 2 m/s takes to
/// use up half a metre, long beside the noise of a ping.
constexpr double kMemory_s = 1;
/// Slower than this no slope is made of what passes below.
constexpr double kUnderWay_mps = 0.3;
/// A floor that comes up faster than this is an error of the sensor, or a wall.
constexpr double kFastest_mps = 10;
constexpr double kAfterLead_s = 1;

/// Returns the least of `floor` - clearance + slope x distance from `x_m` on.
double BoundAt(std::span<const FloorPoint> floor, const Clearance& clearance, double x_m) {
  double least_m = std::numeric_limits<double>::infinity();
  const FloorPoint* before = nullptr;
  const auto take = [&](double ahead_m, double z_m) {
    least_m = std::min(least_m, z_m + clearance.max_slope * (ahead_m - x_m));
  };
  for (const FloorPoint& point : floor) {
    if (point.ahead_m >= x_m) {
      if (before != nullptr && before->ahead_m < x_m) {
        const double share = (x_m - before->ahead_m) / (point.ahead_m - before->ahead_m);
        take(x_m, before->z_m + share * (point.z_m - before->z_m));
      }
      take(point.ahead_m, point.z_m);
    }
    before = &point;
  }
  // Beyond the last point the floor goes on as it is there.
  if (before != nullptr && before->ahead_m < x_m) take(x_m, before->z_m);
  return least_m - clearance.clearance_m;
}

}  // namespace

DepthBound BoundOver(std::span<const FloorPoint> floor, const Clearance& clearance) {
  const double lead_m = clearance.speed_mps * DepthBound::kLead_s;
  const double later_m = lead_m + clearance.speed_mps * kAfterLead_s;
  return {.now_m = BoundAt(floor, clearance, 0),
          .soon_m = BoundAt(floor, clearance, lead_m),
          .later_m = BoundAt(floor, clearance, later_m)};
}

void FloorLine::Update(double floor_z_m, double dt_s) {
  if (!z_m_) {
    z_m_ = floor_z_m;
    deepening_mps_ = 0;
    return;
  }
  if (dt_s <= 0) return;
  const double keep = Exp(-dt_s / kMemory_s);
  const double expected_m = *z_m_ + deepening_mps_ * dt_s;
  const double off_m = floor_z_m - expected_m;
  z_m_ = expected_m + (1 - keep * keep) * off_m;
  deepening_mps_ = std::clamp(deepening_mps_ + (1 - keep) * (1 - keep) * off_m / dt_s,
                              -kFastest_mps, kFastest_mps);
}

std::vector<FloorPoint> FloorLine::Ahead(double length_m, double speed_mps) const {
  if (!z_m_) return {};
  if (speed_mps < kUnderWay_mps) return {{.ahead_m = 0, .z_m = *z_m_}};
  return {{.ahead_m = 0, .z_m = *z_m_},
          {.ahead_m = length_m, .z_m = *z_m_ + deepening_mps_ / speed_mps * length_m}};
}

}  // namespace shoal
