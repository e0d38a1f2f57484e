#include "lib/mission/file/path_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace shoal {

std::string PathText(const PathFollowTask& task) {
  WaypointPath path = PathOf(task).path;
  const size_t num_points = path.points_m.size();
  if (num_points == 0) return "no points";
  const auto [least, deepest] = std::minmax_element(
      path.points_m.begin(), path.points_m.end(),
      [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.z() < b.z(); });
  const double least_m = least->z();
  const double deepest_m = deepest->z();
  if (task.end == PathTaskEnd::kReturnToFirst) path.points_m.push_back(path.points_m.front());
  return fmt::format(
      "{} point{}, {:.1f} m, about {:.0f} s at {:g} m/s, depths from {:g} to {:g} m, a square of "
      "{:g} m",
      num_points, num_points == 1 ? "" : "s", TotalLength_m(path),
      EstimateTime_s(path, task.speed_mps), task.speed_mps, least_m, deepest_m,
      EstimateArea(path, 0).side_m);
}

}  // namespace shoal
