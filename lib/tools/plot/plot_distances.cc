#include "lib/tools/plot/plot_distances.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace shoal {

std::vector<double> NearestDistances_m(std::span<const Eigen::Vector3d> positions_m) {
  std::vector<double> nearest_m(positions_m.size(), std::numeric_limits<double>::infinity());
  if (positions_m.empty()) return nearest_m;
  Eigen::Vector3d low = positions_m[0];
  Eigen::Vector3d high = positions_m[0];
  for (const Eigen::Vector3d& position : positions_m) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  const int axis = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
  std::vector<size_t> order(positions_m.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return positions_m[a][axis] < positions_m[b][axis]; });
  for (size_t i = 0; i < order.size(); ++i) {
    const Eigen::Vector3d& here = positions_m[order[i]];
    double& best_m = nearest_m[order[i]];
    for (size_t j = i + 1; j < order.size(); ++j) {
      const Eigen::Vector3d& there = positions_m[order[j]];
      if (there[axis] - here[axis] >= best_m) break;
      best_m = std::min(best_m, (there - here).norm());
    }
    for (size_t j = i; j-- > 0;) {
      const Eigen::Vector3d& there = positions_m[order[j]];
      if (here[axis] - there[axis] >= best_m) break;
      best_m = std::min(best_m, (there - here).norm());
    }
  }
  return nearest_m;
}

}  // namespace shoal
