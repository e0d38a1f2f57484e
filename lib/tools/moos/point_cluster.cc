#include "lib/tools/moos/point_cluster.h"

#include <algorithm>

#include "lib/base/geometry/angles.h"
#include "lib/base/text/letters.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/import_settings.h"

namespace shoal {
namespace {

/// Returns a regular polygon, with corners to the centimetre.
std::vector<Eigen::Vector2d> Regular(const Eigen::Vector2d& middle_m, double radius_m,
                                     int corners) {
  constexpr double kSteps = 100;  // Per metre.
  std::vector<Eigen::Vector2d> polygon_m;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2 * kPi * (i + 0.5) / corners;
    const Eigen::Vector2d corner_m = middle_m + radius_m * UnitVector(angle_rad);
    polygon_m.emplace_back((corner_m * kSteps).array().round() / kSteps + 0.0);
  }
  return polygon_m;
}

/// Andrew's monotone chain, counterclockwise; fewer than three corners where all are on a line.
std::vector<Eigen::Vector2d> ConvexHull(std::vector<Eigen::Vector2d> points_m) {
  const auto is_left = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                          const Eigen::Vector2d& c) {
    const Eigen::Vector2d ab_m = b - a;
    const Eigen::Vector2d ac_m = c - a;
    return ab_m.x() * ac_m.y() - ab_m.y() * ac_m.x() > 1e-9;
  };
  std::sort(points_m.begin(), points_m.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Eigen::Vector2d> hull_m;
  for (int half = 0; half < 2; ++half) {
    const size_t begin = hull_m.size();
    for (const Eigen::Vector2d& point_m : points_m) {
      while (hull_m.size() >= begin + 2 &&
             !is_left(hull_m[hull_m.size() - 2], hull_m.back(), point_m)) {
        hull_m.pop_back();
      }
      hull_m.push_back(point_m);
    }
    hull_m.pop_back();  // It begins the other half.
    std::reverse(points_m.begin(), points_m.end());
  }
  return hull_m;
}

}  // namespace

PointCluster ClusterSettings(const std::vector<MoosFile>& files) {
  PointCluster settings;
  for (const MoosFile& file : files) {
    for (const MoosBlock& block : file.blocks) {
      if (AppClass(block.app) != "pobstaclemgr") continue;
      for (const MoosLine& line : block.lines) {
        const std::string key = LowerCase(line.key);
        if (key == "lasso") settings.is_lasso = LowerCase(line.value) == "true";
        const auto number = NumberIn(line.value);
        if (!number) continue;
        constexpr double kMost = 1'000;
        if (key == "lasso_radius" && *number > 0) settings.lasso_radius_m = *number;
        if (key == "lasso_points") {
          settings.lasso_points = static_cast<int>(std::clamp(*number, 3.0, kMost));
        }
        if (key == "max_pts_per_cluster") {
          settings.most_points = static_cast<size_t>(std::clamp(*number, 1.0, kMost));
        }
      }
      return settings;
    }
  }
  return settings;
}

std::vector<Eigen::Vector2d> HullOf(const PointCluster& cluster) {
  constexpr double kLeastRadius_m = 0.5;
  Eigen::Vector2d middle_m(0, 0);
  for (const Eigen::Vector2d& point_m : cluster.points_m) middle_m += point_m;
  middle_m /= static_cast<double>(cluster.points_m.size());
  if (cluster.is_lasso) return Regular(middle_m, cluster.lasso_radius_m, cluster.lasso_points);
  std::vector<Eigen::Vector2d> hull_m = ConvexHull(cluster.points_m);
  if (hull_m.size() >= 3) return hull_m;
  double radius_m = kLeastRadius_m;
  for (const Eigen::Vector2d& point_m : cluster.points_m) {
    radius_m = std::max(radius_m, (point_m - middle_m).norm());
  }
  return Regular(middle_m, radius_m, 8);
}

}  // namespace shoal
