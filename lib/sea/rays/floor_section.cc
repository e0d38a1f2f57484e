#include "lib/sea/rays/floor_section.h"

#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"

namespace shoal {

std::vector<BoundaryPoint> FloorSection(const SeaFloor& floor, const Eigen::Vector2d& from_m,
                                        const Eigen::Vector2d& to_m, int num_points) {
  SHOAL_CHECK(num_points >= 2 && from_m != to_m, "two places, and at least two points");
  const Eigen::Vector2d way_m = to_m - from_m;
  const double range_m = Hypot(way_m.x(), way_m.y());
  std::vector<BoundaryPoint> bottom;
  for (int i = 0; i < num_points; ++i) {
    const double share = static_cast<double>(i) / (num_points - 1);
    bottom.push_back({share * range_m, floor.DepthAt(from_m + share * way_m)});
  }
  return bottom;
}

}  // namespace shoal
